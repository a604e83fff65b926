#include "films/mesh/node_merger.hpp"

#include <cmath>

namespace breccia::films {

template <int dim>
std::size_t NodeMerger<dim>::number(const Position& position) {
  constexpr double tolerance = 1e-10, square = 1e-6;
  Position in_box = position;
  if (is_periodic_) in_box -= (position.array() + tolerance).floor().matrix();
  const auto square_of = [&](double offset) {
    Square at;
    for (int axis = 0; axis < dim; ++axis) {
      at[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor((in_box[axis] + offset) / square));
    }
    return at;
  };
  const auto first = square_of(-tolerance), last = square_of(tolerance);
  auto at = first;
  for (std::size_t axis = 0; axis < at.size();) {
    if (const auto found = in_square_.find(at); found != in_square_.end()) {
      for (const std::size_t node : found->second) {
        if ((in_box_[node] - in_box).cwiseAbs().maxCoeff() < tolerance) return node;
      }
    }
    for (axis = 0; axis < at.size() && ++at[axis] > last[axis]; ++axis) at[axis] = first[axis];
  }
  in_square_[square_of(0.0)].push_back(positions_.size());
  positions_.push_back(position);
  in_box_.push_back(in_box);
  return positions_.size() - 1;
}

template class NodeMerger<2>;
template class NodeMerger<3>;

}  // namespace breccia::films
