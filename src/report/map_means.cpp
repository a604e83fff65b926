#include "report/map_means.hpp"

#include <algorithm>

namespace breccia {

MapMeans::MapMeans(std::size_t columns, std::size_t most)
    : columns_(columns),
      side_(std::max<std::size_t>(1, (columns + most - 1) / most)),
      means_((columns + side_ - 1) / side_),
      sums_(means_ * means_, 0.0) {}

void MapMeans::add(double value) {
  sums_[row_ / side_ * means_ + column_ / side_] += value;
  if (++column_ < columns_) return;
  column_ = 0;
  ++row_;
}

std::size_t MapMeans::side_of(std::size_t square) const noexcept {
  return std::min(columns_, (square + 1) * side_) - square * side_;
}

std::vector<double> MapMeans::values() const {
  auto means = sums_;
  for (std::size_t i = 0; i < means.size(); ++i) {
    means[i] /= static_cast<double>(side_of(i / means_) * side_of(i % means_));
  }
  return means;
}

}  // namespace breccia
