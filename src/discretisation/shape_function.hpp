#pragma once

#include <cstddef>

#include "breccia/microstructure/vector.hpp"

namespace breccia {

/// Multilinear shape function of one node of a cell at a point in the cell (theory, Eq. 2).
template <int dim>
struct ShapeFunction {
  double weight;
  Vector<dim> gradient;  ///< gradient times the cell side
};

/// `local` is the position relative to the centre of the cell in units of its side. Bit d of the number of a node is
/// set if the node is on the upper side of the cell along axis d.
template <int dim>
[[nodiscard]] constexpr ShapeFunction<dim> shape_function(std::size_t node, const Vector<dim>& local) noexcept {
  Vector<dim> sign{}, factor{};
  for (std::size_t axis = 0; axis < local.size(); ++axis) {
    sign[axis] = ((node >> axis) & 1U) != 0 ? 1.0 : -1.0;
    factor[axis] = 0.5 + sign[axis] * local[axis];
  }
  ShapeFunction<dim> shape{1.0, sign};
  for (std::size_t axis = 0; axis < local.size(); ++axis) {
    shape.weight *= factor[axis];
    for (std::size_t along = 0; along < local.size(); ++along) {
      if (along != axis) shape.gradient[along] *= factor[axis];
    }
  }
  return shape;
}

}  // namespace breccia
