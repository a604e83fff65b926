// Compiled once for every instruction set, with BRECCIA_KERNEL_TABLE naming the table it fills.

#include "cell_row_kernel.hpp"

#include "kernel_registers.hpp"

namespace breccia::dynamics {
namespace {

/// Strain modes of the cells of a register, times the cell side.
struct Modes {
  Pack xx, yy, xy;  ///< of the centre; xy is the engineering shear
  Pack qu, qv;      ///< hourglass modes
};

/// Volumetric strain modes of the cells of a register, times the cell side.
struct VolumeModes {
  Pack centre, qu, qv;
};

/// Theory, Eq. 6: nodes in the order lower left, lower right, upper left, upper right.
BRECCIA_INLINE Modes strain_modes(const NodeValues<2>& below, const NodeValues<2>& above, int cell) {
  const Pack u00 = load(below.x + cell), u10 = load(below.x + cell + 1);
  const Pack u01 = load(above.x + cell), u11 = load(above.x + cell + 1);
  const Pack v00 = load(below.y + cell), v10 = load(below.y + cell + 1);
  const Pack v01 = load(above.y + cell), v11 = load(above.y + cell + 1);
  const Pack ux0 = u10 - u00, ux1 = u11 - u01;
  const Pack vx0 = v10 - v00, vx1 = v11 - v01;
  const Pack uy = (u01 - u00) + (u11 - u10);
  const Pack vy = (v01 - v00) + (v11 - v10);
  return {0.5 * (ux0 + ux1), 0.5 * vy, 0.5 * (uy + (vx0 + vx1)), ux1 - ux0, vx1 - vx0};
}

/// Shear modulus applied to the strain modes: the springs and all Maxwell terms. One material, or those of the cells.
template <class Materials>
BRECCIA_INLINE Modes shear_response(const Materials& materials, const Modes& strain, const Modes& increment,
                                    double* history) {
  const auto g = shear_modulus(materials);
  Modes s = {g * strain.xx, g * strain.yy, g * strain.xy, g * strain.qu, g * strain.qv};
  auto terms = shear_terms(materials);
  for (int k = 0; k < materials.shear_term_count; ++k, history += shear_modes<2> * lanes) {
    const auto& term = terms[k];
    advance<2>(s.xx, history, term, increment.xx);
    advance<2>(s.yy, history + lanes, term, increment.yy);
    advance<2>(s.xy, history + 2 * lanes, term, increment.xy);
    advance<2>(s.qu, history + 3 * lanes, term, increment.qu);
    advance<2>(s.qv, history + 4 * lanes, term, increment.qv);
  }
  return s;
}

/// Bulk modulus applied to the volumetric modes.
template <bool averaged>
BRECCIA_INLINE VolumeModes bulk_response(const MaterialStep& material, const Modes& strain, const Modes& increment,
                                         double* history) {
  constexpr int modes = averaged ? bulk_modes_averaged : bulk_modes_standard<2>;
  const double k_inf = material.bulk;
  VolumeModes p = {k_inf * (strain.xx + strain.yy), k_inf * strain.qu, k_inf * strain.qv};
  for (int k = 0; k < material.bulk_term_count; ++k, history += modes * lanes) {
    const TermStep& term = material.bulk_terms[k];
    advance<2>(p.centre, history, term, increment.xx + increment.yy);
    if constexpr (!averaged) {
      advance<2>(p.qu, history + lanes, term, increment.qu);
      advance<2>(p.qv, history + 2 * lanes, term, increment.qv);
    }
  }
  return p;
}

/// The modulus of equal strains along both axes applied to the strain of the centre.
BRECCIA_INLINE Pack dilatational_response(const CellsOfRegister& cells, const Modes& strain, const Modes& increment,
                                          double* history) {
  Pack p = cells.of_each(&CellMaterialStep::dilatational) * (strain.xx + strain.yy);
  TermsOfCells terms(cells.of_lane, &CellMaterialStep::dilatational_terms);
  for (int k = 0; k < cells.dilatational_term_count; ++k, history += lanes) {
    advance<2>(p, history, terms[k], increment.xx + increment.yy);
  }
  return p;
}

/// Forces of cells of one material each, with averaged volumetric strains (theory, Eq. 7a).
BRECCIA_INLINE Modes forces_of_cells(const CellMaterials& cells, const Modes& strain, const Modes& increment,
                                     int first_lane) {
  const CellsOfRegister of_register = {cells.of_lane + first_lane, cells.shear_term_count,
                                       cells.dilatational_term_count};
  double* history = cells.history + first_lane;
  const Modes s = shear_response(of_register, strain, increment, history);
  history += cells.shear_term_count * shear_modes<2> * lanes;
  const Pack p = dilatational_response(of_register, strain, increment, history);
  return {4.0 * (p + (s.xx - s.yy)), 4.0 * (p - (s.xx - s.yy)), 4.0 * s.xy, 0.5 * s.qu, 0.5 * s.qv};
}

/// Sums over the four points of a cell of one material in closed form (theory, Eq. 7).
template <bool averaged>
BRECCIA_INLINE Modes uniform_forces(const Modes& s, const VolumeModes& p) {
  Modes force{};
  force.xx = 4.0 * (p.centre + (4.0 / 3.0) * s.xx - (2.0 / 3.0) * s.yy);
  force.yy = 4.0 * (p.centre + (4.0 / 3.0) * s.yy - (2.0 / 3.0) * s.xx);
  force.xy = 4.0 * s.xy;
  force.qu = 0.5 * s.qu;
  force.qv = 0.5 * s.qv;
  if constexpr (!averaged) {
    force.qu += (1.0 / 12.0) * s.qu + 0.25 * p.qu;
    force.qv += (1.0 / 12.0) * s.qv + 0.25 * p.qv;
  }
  return force;
}
/// Adds the sums over the points that belong to a share.
template <bool averaged>
BRECCIA_INLINE void add_shared_forces(Modes& force, const std::uint8_t* points_of_cells, const Modes& s,
                                      const VolumeModes& p) {
  Bits points{};
  for (int lane = 0; lane < width; ++lane) points[lane] = points_of_cells[lane];
  for (int point = 0; point < 4; ++point) {
    Bits bit{};
    for (int lane = 0; lane < width; ++lane) bit[lane] = 1LL << point;
    const Bits mask = (points & bit) != Bits{};
    const double x = (point & 1) != 0 ? 0.25 : -0.25;
    const double y = (point & 2) != 0 ? 0.25 : -0.25;
    // Averaged points see the mean of the volumetric strain, half of it in each direction.
    const Pack gradient_xx = averaged ? 0.5 * (y * s.qu - x * s.qv) : y * s.qu;
    const Pack gradient_yy = averaged ? -gradient_xx : x * s.qv;
    const Pack exx = s.xx + gradient_xx;
    const Pack eyy = s.yy + gradient_yy;
    const Pack pressure = averaged ? p.centre : p.centre + y * p.qu + x * p.qv;
    const Pack dxx = masked(mask, (4.0 / 3.0) * exx - (2.0 / 3.0) * eyy);
    const Pack dyy = masked(mask, (4.0 / 3.0) * eyy - (2.0 / 3.0) * exx);
    const Pack sxy = masked(mask, s.xy + x * s.qu + y * s.qv);
    const Pack sp = masked(mask, pressure);
    force.xx += sp + dxx;
    force.yy += sp + dyy;
    force.xy += sxy;
    force.qu += y * (averaged ? 0.5 * (dxx - dyy) : sp + dxx) + x * sxy;
    force.qv += x * (averaged ? 0.5 * (dyy - dxx) : sp + dyy) + y * sxy;
  }
}

/// Forces on the nodes: minus a quarter (the volume of a point) of the transpose of Eq. 6.
BRECCIA_INLINE void store_forces(const Modes& f, const CellRow<2>& row, int cell) {
  const Pack xx = 0.125 * f.xx, yy = 0.125 * f.yy, xy = 0.125 * f.xy;
  const Pack qu = 0.25 * f.qu, qv = 0.25 * f.qv;
  store(row.below.left_x + cell, (xx + xy) - qu);
  store(row.below.right_x + cell + 1, (xy - xx) + qu);
  store(row.above.left_x + cell, (xx - xy) + qu);
  store(row.above.right_x + cell + 1, -(xx + xy) - qu);
  store(row.below.left_y + cell, (yy + xy) - qv);
  store(row.below.right_y + cell + 1, (yy - xy) + qv);
  store(row.above.left_y + cell, (xy - yy) + qv);
  store(row.above.right_y + cell + 1, -(yy + xy) - qv);
}

/// Forces of the cells of one register, times the cell side.
template <bool averaged>
BRECCIA_INLINE Modes forces(const CellRow<2>& row, const Block& block, int cell, int first_lane) {
  const Modes strain = strain_modes(row.displacement_below, row.displacement_above, cell);
  Modes increment{};
  if (block.relaxes) increment = strain_modes(row.increment_below, row.increment_above, cell);
  if (averaged && block.by_cell != nullptr) return forces_of_cells(*block.by_cell, strain, increment, first_lane);
  Modes force{};
  for (int i = 0; i < block.share_count; ++i) {
    const Share& share = block.shares[i];
    const MaterialStep& material = *share.material;
    double* shear_history = share.history + first_lane;
    double* bulk_history = shear_history + material.shear_term_count * shear_modes<2> * lanes;
    const Modes s = shear_response(material, strain, increment, shear_history);
    const VolumeModes p = bulk_response<averaged>(material, strain, increment, bulk_history);
    if (block.uniform) {
      force = uniform_forces<averaged>(s, p);
    } else {
      add_shared_forces<averaged>(force, share.points + first_lane, s, p);
    }
  }
  return force;
}
template <bool averaged>
void cell_row(const CellRow<2>& row) {
  LaneSums stress_xx, stress_yy, stress_xy;
  for (int b = 0; b < row.block_count; ++b) {
    if constexpr (!fetches_among_terms) {
      if (row.blocks[b].relaxes) fetch_ahead<2>(row.blocks[b]);
    }
    for (int part = 0; part < parts; ++part) {
      const int cell = b * lanes + part * width;
      const Modes force = forces<averaged>(row, row.blocks[b], cell, part * width);
      stress_xx.add(part, force.xx);
      stress_yy.add(part, force.yy);
      stress_xy.add(part, force.xy);
      store_forces(force, row, cell);
    }
  }
  row.stress[0] = stress_xx.total();
  row.stress[1] = stress_yy.total();
  row.stress[2] = stress_xy.total();
}

BRECCIA_INLINE void move_nodes(const NodeRow<2>& row, int node, double* displacement, double* increment,
                               const double* left_below, const double* right_below, const double* left_above,
                               const double* right_above) {
  const Pack force =
      (load(left_below + node) + load(right_below + node)) + (load(left_above + node) + load(right_above + node));
  const Pack moved = load(increment + node) + load(row.step_over_mass + node) * force;
  store(increment + node, moved);
  store(displacement + node, load(displacement + node) + moved);
}

void node_row(const NodeRow<2>& row) {
  const LayerForces<2>& below = row.from_cells_below;
  const LayerForces<2>& above = row.from_cells_above;
  for (int node = 0; node < row.count; node += width) {
    move_nodes(row, node, row.displacement_x, row.increment_x, below.left_x, below.right_x, above.left_x,
               above.right_x);
    move_nodes(row, node, row.displacement_y, row.increment_y, below.left_y, below.right_y, above.left_y,
               above.right_y);
  }
}

}  // namespace

extern const KernelTable<2> BRECCIA_KERNEL_TABLE;
const KernelTable<2> BRECCIA_KERNEL_TABLE = {cell_row<true>, cell_row<false>, node_row};

}  // namespace breccia::dynamics
