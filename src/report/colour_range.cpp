#include "colour_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace breccia {
namespace {

/// The quantile of the values for a share, 0 to 1.
double percentile(std::vector<double> values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

}  // namespace

ColourRange::ColourRange(ColourScale scale, const std::vector<double>& values) : scale_(scale) {
  constexpr double left_out = 0.01;
  std::vector<double> shown = values;
  if (is_logarithmic()) std::erase_if(shown, [](double value) { return value <= 0.0; });
  if (shown.empty()) shown = {1.0};
  from_ = percentile(shown, left_out);
  to_ = percentile(shown, 1.0 - left_out);
  // A uniform field gets the middle colour, without patterns from rounding.
  constexpr double least_span = 1e-6;
  if (to_ - from_ > least_span * std::max(std::abs(from_), std::abs(to_))) return;
  const double middle = 0.5 * (from_ + to_);
  from_ = middle == 0.0 ? -1.0 : std::min(0.5 * middle, 1.5 * middle);
  to_ = middle == 0.0 ? 1.0 : std::max(0.5 * middle, 1.5 * middle);
}

double ColourRange::value_at(double share) const {
  return is_logarithmic() ? from_ * std::pow(to_ / from_, share) : std::lerp(from_, to_, share);
}

std::uint8_t ColourRange::index_of(double value) const {
  constexpr double last = 255.0;
  if (is_logarithmic() && value <= 0.0) return 0;
  const double share =
      is_logarithmic() ? std::log(value / from_) / std::log(to_ / from_) : (value - from_) / (to_ - from_);
  return static_cast<std::uint8_t>(std::lround(last * std::clamp(share, 0.0, 1.0)));
}

}  // namespace breccia
