#pragma once

// The strain modes of square cells, for the kernels: see kernel_registers.hpp.

#include "dynamics/kernel_registers.hpp"
#include "dynamics/point_map.hpp"

namespace breccia::dynamics {
namespace {  // NOLINT(google-build-namespaces): see above

/// Differences of a component of a nodal value: along x, between the nodes below and between those above the cells, and
/// along y, as a sum.
struct SquareDifferences {
  Pack below, above, upwards;
};

BRECCIA_INLINE SquareDifferences differences(const NodeValues<2>* rows, int axis, int cell) {
  const double *below = rows[0].of_axis[axis] + cell, *above = rows[1].of_axis[axis] + cell;
  const Pack v00 = load(below), v10 = load(below + 1), v01 = load(above), v11 = load(above + 1);
  return {v10 - v00, v11 - v01, (v01 - v00) + (v11 - v10)};
}

/// The strain modes from the rows of nodes below and above the cells (theory, Eq. 6).
BRECCIA_INLINE Modes<2> strain_modes(const NodeValues<2>* rows, int cell) {
  const SquareDifferences u = differences(rows, 0, cell), v = differences(rows, 1, cell);
  return {{0.5 * (u.below + u.above), 0.5 * v.upwards, 0.5 * (u.upwards + (v.below + v.above)), u.above - u.below,
           v.above - v.below}};
}

/// The volumetric strain of the centre, and those hourglass modes that change the volume.
BRECCIA_INLINE VolumeModes<2> volume_modes(const Modes<2>& modes) {
  return {{modes.of[SquareMode::xx] + modes.of[SquareMode::yy], modes.of[SquareMode::qu], modes.of[SquareMode::qv]}};
}

/// Forces on the modes of cells with averaged volumetric strains, where their moduli have been applied to the modes,
/// and their dilatational moduli to the volumetric strain (theory, Eq. 7a).
BRECCIA_INLINE Modes<2> forces_of_whole_cells(const Modes<2>& s, const Pack& p) {
  const Pack difference = s.of[SquareMode::xx] - s.of[SquareMode::yy];
  return {{4.0 * (p + difference), 4.0 * (p - difference), 4.0 * s.of[SquareMode::xy], 0.5 * s.of[SquareMode::qu],
           0.5 * s.of[SquareMode::qv]}};
}

/// Sums over the four points of cells of one material in closed form (theory, Eq. 7).
template <bool averaged>
BRECCIA_INLINE Modes<2> uniform_forces(const Modes<2>& s, const VolumeModes<2>& p) {
  Modes<2> force = {{4.0 * (p.of[0] + (4.0 / 3.0) * s.of[SquareMode::xx] - (2.0 / 3.0) * s.of[SquareMode::yy]),
                     4.0 * (p.of[0] + (4.0 / 3.0) * s.of[SquareMode::yy] - (2.0 / 3.0) * s.of[SquareMode::xx]),
                     4.0 * s.of[SquareMode::xy], 0.5 * s.of[SquareMode::qu], 0.5 * s.of[SquareMode::qv]}};
  if constexpr (!averaged) {
    force.of[SquareMode::qu] += (1.0 / 12.0) * s.of[SquareMode::qu] + 0.25 * p.of[1];
    force.of[SquareMode::qv] += (1.0 / 12.0) * s.of[SquareMode::qv] + 0.25 * p.of[2];
  }
  return force;
}

/// Forces along one axis on the nodes below and above: minus a quarter (the volume of a point) of the transpose of
/// Eq. 6.
BRECCIA_INLINE void find_node_forces(const Modes<2>& f, int axis, NodeForces* rows) {
  const Pack along_x = 0.125 * f.of[axis == 0 ? SquareMode::xx : SquareMode::xy],
             along_y = 0.125 * f.of[axis == 0 ? SquareMode::xy : SquareMode::yy];
  const Pack q = 0.25 * f.of[axis == 0 ? SquareMode::qu : SquareMode::qv];
  rows[0] = {(along_x + along_y) - q, (along_y - along_x) + q};
  rows[1] = {(along_x - along_y) + q, -(along_x + along_y) - q};
}

}  // namespace
}  // namespace breccia::dynamics
