#pragma once

// The strain modes of cubic cells, for the kernels: see kernel_registers.hpp. Their numbers are those of CubeMode.

#include "dynamics/kernel_registers.hpp"
#include "dynamics/point_map.hpp"

namespace breccia::dynamics {
namespace {  // NOLINT(google-build-namespaces): see above

/// The axis that is neither of two different ones.
constexpr int third_axis(int one, int other) {
  return CubeMode::axes - one - other;
}

/// Index of the shear of two axes in Voigt's order.
constexpr int shear_index(int one, int other) {
  return CubeMode::axes + third_axis(one, other);
}

// NOLINTBEGIN(modernize-avoid-c-arrays): nothing of the standard library here

/// Differences of a nodal value over the corners of the cells (theory, Eq. 70): along one axis, along two, numbered by
/// the third, and along all.
struct CornerDifferences {
  Pack single[CubeMode::axes];
  Pack twofold[CubeMode::axes];
  Pack threefold;
};

/// The differences of a component of the values along the four rows of nodes.
BRECCIA_INLINE CornerDifferences corner_differences(const NodeValues<3>* rows, int axis, int cell) {
  Pack step[4], sum[4];  // along x
  for (int row = 0; row < 4; ++row) {
    const Pack left = load(rows[row].of_axis[axis] + cell), right = load(rows[row].of_axis[axis] + cell + 1);
    step[row] = right - left;
    sum[row] = right + left;
  }
  // Values below and above: differences along the axes in the name, and sums along the other ones of x and y.
  Pack x[2], xy[2], y[2], none[2];
  for (int z = 0; z < 2; ++z) {
    const int lower = 2 * z, upper = 2 * z + 1;
    x[z] = step[upper] + step[lower];
    xy[z] = step[upper] - step[lower];
    y[z] = sum[upper] - sum[lower];
    none[z] = sum[upper] + sum[lower];
  }
  return {{x[1] + x[0], y[1] + y[0], none[1] - none[0]}, {y[1] - y[0], x[1] - x[0], xy[1] + xy[0]}, xy[1] - xy[0]};
}

/// The strain modes from the rows of nodes around the cells (theory, Eq. 70 and 73).
BRECCIA_INLINE Modes<3> strain_modes(const NodeValues<3>* rows, int cell) {
  constexpr int axes = CubeMode::axes;
  Modes<3> modes;  // NOLINT(cppcoreguidelines-pro-type-member-init): all modes are set below
  Pack gradient[axes][axes];
  for (int c = 0; c < axes; ++c) {
    const CornerDifferences differences = corner_differences(rows, c, cell);
    for (int d = 0; d < axes; ++d) {
      gradient[c][d] = 0.25 * differences.single[d];
      modes.of[CubeMode::twist(c, d)] = 0.125 * differences.twofold[d];
    }
    modes.of[CubeMode::warp(c)] = 0.0625 * differences.threefold;
  }
  for (int c = 0; c < axes; ++c) {
    const int d = (c + 1) % axes, e = (c + 2) % axes;
    modes.of[c] = gradient[c][c];
    modes.of[axes + c] = gradient[d][e] + gradient[e][d];
  }
  return modes;
}

BRECCIA_INLINE Pack trace(const Modes<3>& modes) {
  return (modes.of[0] + modes.of[1]) + modes.of[2];
}

/// The volumetric strain of the centre; its changes along each axis; those along each pair of axes, numbered by the
/// third.
BRECCIA_INLINE VolumeModes<3> volume_modes(const Modes<3>& modes) {
  constexpr int axes = CubeMode::axes;
  VolumeModes<3> volume;  // NOLINT(cppcoreguidelines-pro-type-member-init): all modes are set below
  volume.of[0] = trace(modes);
  for (int axis = 0; axis < axes; ++axis) {
    const int next = (axis + 1) % axes, last = (axis + 2) % axes;
    volume.of[1 + axis] = modes.of[CubeMode::twist(next, last)] + modes.of[CubeMode::twist(last, next)];
    volume.of[1 + axes + axis] = modes.of[CubeMode::warp(axis)];
  }
  return volume;
}

/// Forces on the modes of cells of one material with averaged volumetric strains, where the shear modulus has been
/// applied to the modes, and the bulk modulus to the volumetric strain (theory, Eq. 74).
BRECCIA_INLINE Modes<3> forces_of_whole_cells(const Modes<3>& s, const Pack& pressure) {
  constexpr int axes = CubeMode::axes;
  constexpr double points = points_of_cell<3>;
  Modes<3> force;  // NOLINT(cppcoreguidelines-pro-type-member-init): all modes are set below
  const Pack volume = pressure - (2.0 / 3.0) * trace(s);
  for (int c = 0; c < axes; ++c) {
    force.of[c] = points * (volume + 2.0 * s.of[c]);
    force.of[axes + c] = points * s.of[axes + c];
    force.of[CubeMode::warp(c)] = points * ((10.0 / 3.0) * s.of[CubeMode::warp(c)]);
  }
  const auto twist = [&s](int c, int d) -> const Pack& { return s.of[CubeMode::twist(c, d)]; };
  const Pack turns = (twist(0, 0) + twist(1, 1)) + twist(2, 2);
  for (int c = 0; c < axes; ++c) {
    for (int d = 0; d < axes; ++d) {
      force.of[CubeMode::twist(c, d)] =
          points * (c == d ? twist(c, c) + turns : (7.0 / 3.0) * twist(c, d) - (2.0 / 3.0) * twist(d, c));
    }
  }
  return force;
}

/// Sums over the eight points of cells of one material, with either kind of volumetric strains.
template <bool averaged>
BRECCIA_INLINE Modes<3> uniform_forces(const Modes<3>& s, const VolumeModes<3>& p) {
  constexpr int axes = CubeMode::axes;
  Modes<3> force = forces_of_whole_cells(s, p.of[0]);
  if constexpr (!averaged) {
    constexpr double points = points_of_cell<3>;
    for (int c = 0; c < axes; ++c) {
      for (int d = 0; d < axes; ++d) {
        if (c != d) force.of[CubeMode::twist(c, d)] += points * p.of[1 + third_axis(c, d)];
      }
      force.of[CubeMode::warp(c)] += points * p.of[1 + axes + c];
    }
  }
  return force;
}

/// Forces along one axis on the four rows of nodes: minus an eighth (the volume of a point) of the transpose of Eq. 70
/// and 73.
BRECCIA_INLINE void find_node_forces(const Modes<3>& f, int c, NodeForces* rows) {
  constexpr int axes = CubeMode::axes;
  constexpr double volume = 1.0 / points_of_cell<3>;
  Pack single[axes], twofold[axes];
  for (int d = 0; d < axes; ++d) {
    single[d] = (0.25 * volume) * f.of[c == d ? c : shear_index(c, d)];
    twofold[d] = (0.125 * volume) * f.of[CubeMode::twist(c, d)];
  }
  const Pack threefold = (0.0625 * volume) * f.of[CubeMode::warp(c)];
  const Pack x[2] = {single[0] - twofold[1], single[0] + twofold[1]};
  const Pack xy[2] = {twofold[2] - threefold, twofold[2] + threefold};
  const Pack y[2] = {single[1] - twofold[0], single[1] + twofold[0]};
  const Pack none[2] = {-single[2], single[2]};
  for (int z = 0; z < 2; ++z) {
    const Pack step[2] = {x[z] - xy[z], x[z] + xy[z]};
    const Pack sum[2] = {none[z] - y[z], none[z] + y[z]};
    for (int side = 0; side < 2; ++side) rows[2 * z + side] = {step[side] - sum[side], -(step[side] + sum[side])};
  }
}

// NOLINTEND(modernize-avoid-c-arrays)

}  // namespace
}  // namespace breccia::dynamics
