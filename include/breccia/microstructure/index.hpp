#pragma once

#include <array>
#include <cstddef>

namespace breccia {

/// The indices of a cell or point of a lattice along each axis, or the numbers of cells or points along each axis.
template <int dim>
using Index = std::array<int, static_cast<std::size_t>(dim)>;

/// A range of indices: from `begin` up to, but not including, `end` along every axis.
template <int dim>
struct IndexRange {
  Index<dim> begin{}, end{};

  /// Number of indices along each axis.
  [[nodiscard]] Index<dim> size() const noexcept {
    auto size = end;
    for (std::size_t axis = 0; axis < size.size(); ++axis) size[axis] -= begin[axis];
    return size;
  }
  [[nodiscard]] bool contains(const Index<dim>& index) const noexcept {
    for (std::size_t axis = 0; axis < index.size(); ++axis) {
      if (index[axis] < begin[axis] || index[axis] >= end[axis]) return false;
    }
    return true;
  }
  /// Position of an index in the list of all indices in the range, where the first axis runs fastest.
  [[nodiscard]] std::size_t place_of(const Index<dim>& index) const noexcept {
    std::size_t number = 0;
    for (std::size_t axis = index.size(); axis-- > 0;) {
      number = number * static_cast<std::size_t>(end[axis] - begin[axis]) +
               static_cast<std::size_t>(index[axis] - begin[axis]);
    }
    return number;
  }
};

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
