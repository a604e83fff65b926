#pragma once

#include <array>
#include <cstddef>

namespace breccia {

/// A place on a lattice, or the number of places along each axis.
template <int dim>
using Index = std::array<int, static_cast<std::size_t>(dim)>;

/// Calls action(index) for all indices with begin <= index < end along every axis. The first axis runs fastest.
template <std::size_t dim, class Action>
constexpr void for_each_index(const std::array<int, dim>& begin, const std::array<int, dim>& end, Action&& action) {
  for (std::size_t axis = 0; axis < dim; ++axis) {
    if (begin[axis] >= end[axis]) return;
  }
  auto index = begin;
  for (std::size_t axis = 0; axis < dim;) {
    action(static_cast<const std::array<int, dim>&>(index));
    for (axis = 0; axis < dim && ++index[axis] == end[axis]; ++axis) index[axis] = begin[axis];
  }
}

}  // namespace breccia
