#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "breccia/microstructure/vector.hpp"

namespace breccia::gaps {

// Places and lengths are in units of the cell side, from the lowest node of a cell. Nodes are in the order of
// CellShape<3>; face 2 a is the lower face along axis a, face 2 a + 1 the upper one. The axes of a face are the other
// two in their order.

/// Where the owner changes along the edges of a cubic cell (edge_of_cell), as in ChangesOfOwner.
using ChangesInCell = std::array<std::optional<double>, 12>;

/// The number of the edge of a cell that goes from a node along an axis.
[[nodiscard]] constexpr std::size_t edge_of_cell(std::size_t node, std::size_t axis) noexcept {
  const std::size_t below = node & ((std::size_t{1} << axis) - 1), above = node >> (axis + 1);
  return 4 * axis + (below | above << axis);
}

/// The node of a cell that is a node of one of its faces.
[[nodiscard]] constexpr std::size_t node_of_face(std::size_t face, std::size_t node) noexcept {
  const std::size_t normal = face / 2, upper = face % 2;
  const std::size_t below = node & ((std::size_t{1} << normal) - 1), above = node >> normal;
  return below | upper << normal | above << (normal + 1);
}

/// The axis of a cell that is the first or second axis of a face.
[[nodiscard]] constexpr std::size_t axis_of_face(std::size_t face, std::size_t axis) noexcept {
  return axis < face / 2 ? axis : axis + 1;
}

/// The polygon in the middle of the gap between two particles in a cell.
struct FacetCorners {
  std::vector<Vector<3>> corners;
  std::vector<std::size_t> faces;  ///< by edge of the polygon, which goes from its corner to the next one, on this face
};

/// The polygon that joins the changes of owner on the edges of a cell; nothing where they are not one polygon, as in a
/// cell of one owner, or one whose owners alternate around a face.
[[nodiscard]] std::optional<FacetCorners> corners_of_facet(const ChangesInCell& changes);

}  // namespace breccia::gaps
