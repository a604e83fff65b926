#pragma once

#include <array>
#include <cstddef>

#include "discretisation/gaps/gap_cell.hpp"

namespace breccia::gaps {

// The unknowns of gaps in a cubic cell are the flows through its faces (facet_corners.hpp), and the slopes of each
// node: how each component of the displacement of its particle changes from the node along both other axes.

/// Number in its cell of the flow through a face along its normal axis (in units of CubeFace::unit_of_flow).
[[nodiscard]] constexpr int flow_through_cube(int face) noexcept {
  return CellShape<3>::dofs + face;
}

/// The derivative of a displacement component along another axis.
struct Slope {
  std::size_t component, along;

  /// Its number among those of a node.
  [[nodiscard]] constexpr std::size_t number() const noexcept { return 2 * component + along - (along > component); }
};
inline constexpr std::array<Slope, 6> slopes_of_node = {{{0, 1}, {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 1}}};

/// Number of a slope of a node in its cell.
[[nodiscard]] constexpr int slope_at(int node, const Slope& slope) noexcept {
  return flow_through_cube(faces_of_cell<3>) + static_cast<int>(slopes_of_node.size()) * node +
         static_cast<int>(slope.number());
}

static_assert(gap_unknowns_of_cell<3> == faces_of_cell<3> + 6 * CellShape<3>::nodes);

}  // namespace breccia::gaps
