// The kernel of cubic cells. Compiled once for every instruction set, with BRECCIA_CUBE_KERNEL_TABLE naming the table
// it fills.

#include "cube_row_kernel.hpp"

#include "kernel_registers.hpp"

namespace breccia::dynamics {
namespace {

constexpr int axes = 3;
constexpr int cube_points = 8;

/// The axis that is neither of two different ones.
constexpr int third_axis(int one, int other) {
  return axes - one - other;
}

/// Strain modes of the cells of a register, or what a modulus makes of them, times the cell side (theory, Eq. 73).
struct CubeModes {
  // NOLINTBEGIN(modernize-avoid-c-arrays): nothing of the standard library here
  Pack mean[6];            ///< strain of the centre in Voigt's order, with engineering shears
  Pack twist[axes][axes];  ///< [c][d]: of the component c, the gradient across d along both of the other axes
  Pack warp[axes];         ///< [c]: of the component c, the gradient along all axes
  // NOLINTEND(modernize-avoid-c-arrays)
};

/// Index of the shear of two axes in Voigt's order.
constexpr int shear_index(int one, int other) {
  return 3 + third_axis(one, other);
}

/// The volumetric modes: of the centre; along each axis; along each pair of axes, numbered by the third.
struct CubeVolumeModes {
  Pack centre;
  Pack along[axes];   // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
  Pack across[axes];  // NOLINT(modernize-avoid-c-arrays)
};

/// Differences of a nodal value over the corners of the cells (theory, Eq. 70): along one axis, along two, numbered by
/// the third, and along all.
struct CornerDifferences {
  Pack single[axes];   // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
  Pack twofold[axes];  // NOLINT(modernize-avoid-c-arrays)
  Pack threefold;
};

/// Differences of the values along the four rows of nodes, at the indices of the cells.
BRECCIA_INLINE CornerDifferences corner_differences(const NodeValues<3>* rows, int axis, int cell) {
  // NOLINTBEGIN(modernize-avoid-c-arrays): nothing of the standard library here
  Pack step[4], sum[4];  // along x
  for (int row = 0; row < 4; ++row) {
    const Pack left = load(rows[row].of_axis[axis] + cell), right = load(rows[row].of_axis[axis] + cell + 1);
    step[row] = right - left;
    sum[row] = right + left;
  }
  Pack x[2], xy[2], y[2], none[2];  // below and above: differences along these of the first two axes, else sums
  // NOLINTEND(modernize-avoid-c-arrays)
  for (int z = 0; z < 2; ++z) {
    const int lower = 2 * z, upper = 2 * z + 1;
    x[z] = step[upper] + step[lower];
    xy[z] = step[upper] - step[lower];
    y[z] = sum[upper] - sum[lower];
    none[z] = sum[upper] + sum[lower];
  }
  return {{x[1] + x[0], y[1] + y[0], none[1] - none[0]}, {y[1] - y[0], x[1] - x[0], xy[1] + xy[0]}, xy[1] - xy[0]};
}

/// Theory, Eq. 70 and 73.
BRECCIA_INLINE CubeModes strain_modes(const NodeValues<3>* rows, int cell) {
  CubeModes modes;
  Pack gradient[axes][axes];  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
  for (int c = 0; c < axes; ++c) {
    const CornerDifferences differences = corner_differences(rows, c, cell);
    for (int d = 0; d < axes; ++d) {
      gradient[c][d] = 0.25 * differences.single[d];
      modes.twist[c][d] = 0.125 * differences.twofold[d];
    }
    modes.warp[c] = 0.0625 * differences.threefold;
  }
  for (int c = 0; c < axes; ++c) {
    modes.mean[c] = gradient[c][c];
    modes.mean[3 + c] = gradient[(c + 1) % axes][(c + 2) % axes] + gradient[(c + 2) % axes][(c + 1) % axes];
  }
  return modes;
}

BRECCIA_INLINE Pack trace(const CubeModes& modes) {
  return (modes.mean[0] + modes.mean[1]) + modes.mean[2];
}

/// The volumetric strain that changes sign along an axis.
BRECCIA_INLINE Pack volume_along(const CubeModes& modes, int axis) {
  const int next = (axis + 1) % axes, last = (axis + 2) % axes;
  return modes.twist[next][last] + modes.twist[last][next];
}

/// Shear modulus applied to the strain modes: the springs and all Maxwell terms. One material, or those of the cells.
template <class Materials>
BRECCIA_INLINE CubeModes shear_response(const Materials& materials, const CubeModes& strain, const CubeModes& increment,
                                        double* history) {
  const auto g = shear_modulus(materials);
  CubeModes s;
  for (int i = 0; i < 6; ++i) s.mean[i] = g * strain.mean[i];
  for (int c = 0; c < axes; ++c) {
    for (int d = 0; d < axes; ++d) s.twist[c][d] = g * strain.twist[c][d];
    s.warp[c] = g * strain.warp[c];
  }
  auto terms = shear_terms(materials);
  for (int k = 0; k < materials.shear_term_count; ++k) {
    const auto& term = terms[k];
    for (int i = 0; i < 6; ++i, history += lanes) advance<3>(s.mean[i], history, term, increment.mean[i]);
    for (int c = 0; c < axes; ++c) {
      for (int d = 0; d < axes; ++d, history += lanes) advance<3>(s.twist[c][d], history, term, increment.twist[c][d]);
    }
    for (int c = 0; c < axes; ++c, history += lanes) advance<3>(s.warp[c], history, term, increment.warp[c]);
  }
  return s;
}

/// Bulk modulus applied to the volumetric modes.
template <bool averaged>
BRECCIA_INLINE CubeVolumeModes bulk_response(const MaterialStep& material, const CubeModes& strain,
                                             const CubeModes& increment, double* history) {
  const double k_inf = material.bulk;
  CubeVolumeModes p;
  p.centre = k_inf * trace(strain);
  for (int axis = 0; axis < axes; ++axis) {
    p.along[axis] = k_inf * volume_along(strain, axis);
    p.across[axis] = k_inf * strain.warp[axis];
  }
  for (int k = 0; k < material.bulk_term_count; ++k) {
    const TermStep& term = material.bulk_terms[k];
    advance<3>(p.centre, history, term, trace(increment));
    history += lanes;
    if constexpr (!averaged) {
      for (int axis = 0; axis < axes; ++axis, history += lanes) {
        advance<3>(p.along[axis], history, term, volume_along(increment, axis));
      }
      for (int axis = 0; axis < axes; ++axis, history += lanes) {
        advance<3>(p.across[axis], history, term, increment.warp[axis]);
      }
    }
  }
  return p;
}

/// The bulk modulus of each cell applied to the strain of the centre.
BRECCIA_INLINE Pack bulk_response(const CellsOfRegister& cells, const CubeModes& strain, const CubeModes& increment,
                                  double* history) {
  Pack p = cells.of_each(&CellMaterialStep::dilatational) * trace(strain);
  TermsOfCells terms(cells.of_lane, &CellMaterialStep::dilatational_terms);
  for (int k = 0; k < cells.dilatational_term_count; ++k, history += lanes) {
    advance<3>(p, history, terms[k], trace(increment));
  }
  return p;
}

/// Sums over the eight points of cells of one material with averaged volumetric strains: forces on the modes (theory,
/// Eq. 74).
BRECCIA_INLINE CubeModes forces_of_modes(const CubeModes& s, const Pack& pressure) {
  constexpr double points = cube_points;
  CubeModes force;
  const Pack volume = pressure - (2.0 / 3.0) * trace(s);
  for (int c = 0; c < axes; ++c) {
    force.mean[c] = points * (volume + 2.0 * s.mean[c]);
    force.mean[3 + c] = points * s.mean[3 + c];
    force.warp[c] = points * ((10.0 / 3.0) * s.warp[c]);
  }
  const Pack turns = (s.twist[0][0] + s.twist[1][1]) + s.twist[2][2];
  for (int c = 0; c < axes; ++c) {
    for (int d = 0; d < axes; ++d) {
      force.twist[c][d] =
          points * (c == d ? s.twist[c][c] + turns : (7.0 / 3.0) * s.twist[c][d] - (2.0 / 3.0) * s.twist[d][c]);
    }
  }
  return force;
}

/// Forces of cells of one material each, with averaged volumetric strains.
BRECCIA_INLINE CubeModes forces_of_cells(const CellMaterials& cells, const CubeModes& strain,
                                         const CubeModes& increment, int first_lane) {
  const CellsOfRegister of_register = {cells.of_lane + first_lane, cells.shear_term_count,
                                       cells.dilatational_term_count};
  double* history = cells.history + first_lane;
  const CubeModes s = shear_response(of_register, strain, increment, history);
  history += cells.shear_term_count * shear_modes<3> * lanes;
  return forces_of_modes(s, bulk_response(of_register, strain, increment, history));
}

/// The same sums for the points of one material with either kind of volumetric strains.
template <bool averaged>
BRECCIA_INLINE CubeModes uniform_forces(const CubeModes& s, const CubeVolumeModes& p) {
  CubeModes force = forces_of_modes(s, p.centre);
  if constexpr (!averaged) {
    constexpr double points = cube_points;
    for (int c = 0; c < axes; ++c) {
      for (int d = 0; d < axes; ++d) {
        if (c != d) force.twist[c][d] += points * p.along[third_axis(c, d)];
      }
      force.warp[c] += points * p.across[c];
    }
  }
  return force;
}

/// Adds the sums over the points that belong to a share.
template <bool averaged>
BRECCIA_INLINE void add_shared_forces(CubeModes& force, const std::uint8_t* points_of_cells, const CubeModes& s,
                                      const CubeVolumeModes& p) {
  Bits points{};
  for (int lane = 0; lane < width; ++lane) points[lane] = points_of_cells[lane];
  for (int point = 0; point < cube_points; ++point) {
    Bits bit{};
    for (int lane = 0; lane < width; ++lane) bit[lane] = 1LL << point;
    const Bits mask = (points & bit) != Bits{};
    // NOLINTBEGIN(modernize-avoid-c-arrays): nothing of the standard library here
    const double sign[axes] = {(point & 1) != 0 ? 1.0 : -1.0, (point & 2) != 0 ? 1.0 : -1.0,
                               (point & 4) != 0 ? 1.0 : -1.0};
    const double pair[axes] = {sign[1] * sign[2], sign[2] * sign[0], sign[0] * sign[1]};
    Pack gradient[axes][axes];  // [c][d]: of the component c along d, without that of the centre
    for (int c = 0; c < axes; ++c) {
      for (int d = 0; d < axes; ++d) {
        const int e = (d + 1) % axes, f = (d + 2) % axes;
        gradient[c][d] = (sign[e] * s.twist[c][f] + sign[f] * s.twist[c][e]) + pair[d] * s.warp[c];
      }
    }
    Pack pressure = p.centre;
    if constexpr (!averaged) {
      for (int c = 0; c < axes; ++c) pressure += sign[c] * p.along[c] + pair[c] * p.across[c];
    }
    Pack stress[axes][axes];  // deviators
    // NOLINTEND(modernize-avoid-c-arrays)
    const Pack volume = trace(s) + ((gradient[0][0] + gradient[1][1]) + gradient[2][2]);
    for (int c = 0; c < axes; ++c) {
      const int d = (c + 1) % axes, e = (c + 2) % axes;
      stress[c][c] = masked(mask, 2.0 * (s.mean[c] + gradient[c][c]) - (2.0 / 3.0) * volume);
      stress[d][e] = stress[e][d] = masked(mask, s.mean[3 + c] + gradient[d][e] + gradient[e][d]);
    }
    pressure = masked(mask, pressure);
    for (int c = 0; c < axes; ++c) {
      force.mean[c] += stress[c][c] + pressure;
      force.mean[3 + c] += stress[(c + 1) % axes][(c + 2) % axes];
      // The pressure of averaged points does no work on hourglass modes.
      if constexpr (!averaged) stress[c][c] += pressure;
    }
    for (int c = 0; c < axes; ++c) {
      for (int d = 0; d < axes; ++d) {
        const int e = (d + 1) % axes, f = (d + 2) % axes;
        force.twist[c][d] += sign[f] * stress[c][e] + sign[e] * stress[c][f];
        force.warp[c] += pair[d] * stress[c][d];
      }
    }
  }
}

/// Forces of the cells of one register, times the cell side.
template <bool averaged>
BRECCIA_INLINE CubeModes forces(const CellRow<3>& row, const Block& block, int cell, int first_lane) {
  const CubeModes strain = strain_modes(row.displacement, cell);
  CubeModes increment{};
  if (block.relaxes) increment = strain_modes(row.increment, cell);
  if (averaged && block.by_cell != nullptr) return forces_of_cells(*block.by_cell, strain, increment, first_lane);
  CubeModes force{};
  for (int i = 0; i < block.share_count; ++i) {
    const Share& share = block.shares[i];
    const MaterialStep& material = *share.material;
    double* shear_history = share.history + first_lane;
    double* bulk_history = shear_history + material.shear_term_count * shear_modes<3> * lanes;
    const CubeModes s = shear_response(material, strain, increment, shear_history);
    const CubeVolumeModes p = bulk_response<averaged>(material, strain, increment, bulk_history);
    if (block.uniform) {
      force = uniform_forces<averaged>(s, p);
    } else {
      add_shared_forces<averaged>(force, share.points + first_lane, s, p);
    }
  }
  return force;
}

/// Forces on the nodes at the left and at the right of the cells, along one row of nodes.
struct NodeForces {
  Pack left, right;
};

/// Forces along one axis on the four rows of nodes: minus an eighth (the volume of a point) of the transpose of Eq. 70
/// and 73.
BRECCIA_INLINE void node_forces(const CubeModes& f, int c, NodeForces* rows) {
  constexpr double volume = 1.0 / cube_points;
  // NOLINTBEGIN(modernize-avoid-c-arrays): nothing of the standard library here
  Pack single[axes], twofold[axes];
  for (int d = 0; d < axes; ++d) {
    single[d] = (0.25 * volume) * f.mean[c == d ? c : shear_index(c, d)];
    twofold[d] = (0.125 * volume) * f.twist[c][d];
  }
  const Pack threefold = (0.0625 * volume) * f.warp[c];
  const Pack x[2] = {single[0] - twofold[1], single[0] + twofold[1]};
  const Pack xy[2] = {twofold[2] - threefold, twofold[2] + threefold};
  const Pack y[2] = {single[1] - twofold[0], single[1] + twofold[0]};
  const Pack none[2] = {-single[2], single[2]};
  // NOLINTEND(modernize-avoid-c-arrays)
  for (int z = 0; z < 2; ++z) {
    const Pack step[2] = {x[z] - xy[z], x[z] + xy[z]};     // NOLINT(modernize-avoid-c-arrays)
    const Pack sum[2] = {none[z] - y[z], none[z] + y[z]};  // NOLINT(modernize-avoid-c-arrays)
    for (int side = 0; side < 2; ++side) rows[2 * z + side] = {step[side] - sum[side], -(step[side] + sum[side])};
  }
}

/// The values one lane further, and in the first lane the last of those before.
template <int... lane>
BRECCIA_INLINE Pack moved_on(const Pack& before, const Pack& values, Lanes<lane...> /*all*/) {
  return __builtin_shufflevector(before, values, (width - 1 + lane)...);
}

/// The forces of the cells to the left of the nodes of a register, which the register before has left behind.
struct ForcesBefore {
  Pack right[axes][4];  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
};

/// Gives the nodes of a register the forces of the cells on both of their sides.
BRECCIA_INLINE void store_forces(const CubeModes& f, const CellRow<3>& row, int cell, ForcesBefore& before) {
  using All = typename LanesUpTo<width>::Type;
  for (int c = 0; c < axes; ++c) {
    NodeForces forces[4];  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
    node_forces(f, c, forces);
    for (int i = 0; i < 4; ++i) {
      double* nodes = row.force[i].of_axis[c] + cell;
      const Pack both = forces[i].left + moved_on(before.right[c][i], forces[i].right, All{});
      store(nodes, (i & 1) == 0 ? load(nodes) + both : both);
      before.right[c][i] = forces[i].right;
    }
  }
}

/// Gives the node behind the last cell its force, and none to those behind it.
BRECCIA_INLINE void store_last_forces(const CellRow<3>& row, const ForcesBefore& before) {
  using All = typename LanesUpTo<width>::Type;
  for (int c = 0; c < axes; ++c) {
    for (int i = 0; i < 4; ++i) {
      double* nodes = row.force[i].of_axis[c] + row.block_count * lanes;
      const Pack last = moved_on(before.right[c][i], Pack{}, All{});
      store(nodes, (i & 1) == 0 ? load(nodes) + last : last);
    }
  }
}

template <bool averaged>
void cube_row(const CellRow<3>& row) {
  LaneSums stress[6];  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
  ForcesBefore before{};
  for (int b = 0; b < row.block_count; ++b) {
    if constexpr (!fetches_among_terms) {
      if (row.blocks[b].relaxes) fetch_ahead<3>(row.blocks[b]);
    }
    for (int part = 0; part < parts; ++part) {
      const int cell = b * lanes + part * width;
      const CubeModes force = forces<averaged>(row, row.blocks[b], cell, part * width);
      for (int i = 0; i < 6; ++i) stress[i].add(part, force.mean[i]);
      store_forces(force, row, cell, before);
    }
  }
  store_last_forces(row, before);
  for (int i = 0; i < 6; ++i) row.stress[i] = stress[i].total();
}

void node_row_of_cubes(const NodeRow<3>& row) {
  for (int node = 0; node < row.count; node += width) {
    const Pack step_over_mass = load(row.step_over_mass + node);
    for (int c = 0; c < axes; ++c) {
      double *u = row.displacement[c] + node, *du = row.increment[c] + node;
      const Pack force = load(row.from_cells_below.of_axis[c] + node) + load(row.from_cells_above.of_axis[c] + node);
      const Pack moved = load(du) + step_over_mass * force;
      store(du, moved);
      store(u, load(u) + moved);
    }
  }
}

}  // namespace

extern const KernelTable<3> BRECCIA_CUBE_KERNEL_TABLE;
const KernelTable<3> BRECCIA_CUBE_KERNEL_TABLE = {cube_row<true>, cube_row<false>, node_row_of_cubes};

}  // namespace breccia::dynamics
