#pragma once

#include "discretisation/gaps/gap_cell.hpp"

namespace breccia::gaps {

/// Each face of a square cell has three unknowns; faces are in the order left, right, lower and upper.
inline constexpr int unknowns_of_face = 3;
static_assert(gap_unknowns_of_cell<2> == unknowns_of_face * faces_of_cell<2>);

/// Number in its cell of the flow through a face along its normal (in units of Face::unit_of_flow), and of the slope of
/// the displacement along the normal in the particle of the first or second node of a face.
[[nodiscard]] constexpr int flow_through(int face) noexcept {
  return CellShape<2>::dofs + unknowns_of_face * face;
}
[[nodiscard]] constexpr int slope_at(int face, int end) noexcept {
  return flow_through(face) + 1 + end;
}

}  // namespace breccia::gaps
