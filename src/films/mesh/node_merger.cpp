#include "films/mesh/node_merger.hpp"

#include <cmath>

namespace breccia::films {

std::size_t NodeMerger::number(const Eigen::Vector2d& position) {
  constexpr double tolerance = 1e-10, square = 1e-6;
  Eigen::Vector2d in_box = position;
  if (is_periodic_) in_box -= (position.array() + tolerance).floor().matrix();
  const auto row_of = [](double x) { return static_cast<std::int64_t>(std::floor(x / square)); };
  for (auto i = row_of(in_box.x() - tolerance); i <= row_of(in_box.x() + tolerance); ++i) {
    for (auto j = row_of(in_box.y() - tolerance); j <= row_of(in_box.y() + tolerance); ++j) {
      const auto found = in_square_.find({i, j});
      if (found == in_square_.end()) continue;
      for (const std::size_t node : found->second) {
        if ((in_box_[node] - in_box).cwiseAbs().maxCoeff() < tolerance) return node;
      }
    }
  }
  in_square_[{row_of(in_box.x()), row_of(in_box.y())}].push_back(positions_.size());
  positions_.push_back(position);
  in_box_.push_back(in_box);
  return positions_.size() - 1;
}

}  // namespace breccia::films
