// This source is compiled once for every instruction set; BRECCIA_KERNELS is the name of its kernels.

#include "dynamics/cell_row_kernel.hpp"

#include "dynamics/cube_modes.hpp"
#include "dynamics/kernel_registers.hpp"
#include "dynamics/point_map.hpp"
#include "dynamics/square_modes.hpp"

namespace breccia::dynamics {
namespace {

/// Shear modulus applied to the strain modes: the springs and all Maxwell terms. `Materials` is one material, or the
/// materials of the cells.
template <class Materials, int dim>
BRECCIA_INLINE Modes<dim> shear_response(const Materials& materials, const Modes<dim>& strain,
                                         const Modes<dim>& increment, double* history) {
  const auto g = shear_modulus(materials);
  Modes<dim> s;  // NOLINT(cppcoreguidelines-pro-type-member-init): all modes are set below
#pragma GCC unroll 18
  for (int i = 0; i < shear_modes<dim>; ++i) s.of[i] = g * strain.of[i];
  auto terms = shear_terms(materials);
  for (int k = 0; k < materials.shear_term_count; ++k) {
    const auto& term = terms[k];
#pragma GCC unroll 18
    for (int i = 0; i < shear_modes<dim>; ++i) advance<dim>(s.of[i], history + i * lanes, term, increment.of[i]);
    history += shear_modes<dim> * lanes;
  }
  return s;
}

/// Bulk modulus applied to the volumetric modes; with averaged volumetric strains to the mode of the centre alone.
template <bool averaged, int dim>
BRECCIA_INLINE VolumeModes<dim> bulk_response(const MaterialStep& material, const Modes<dim>& strain,
                                              const Modes<dim>& increment, double* history) {
  constexpr int modes = averaged ? bulk_modes_averaged : bulk_modes_standard<dim>;
  const double k_inf = material.bulk;
  VolumeModes<dim> p = volume_modes(strain);
  for (int i = 0; i < modes; ++i) p.of[i] = k_inf * p.of[i];
  for (int k = 0; k < material.bulk_term_count; ++k, history += modes * lanes) {
    const VolumeModes<dim> volume = volume_modes(increment);
    for (int i = 0; i < modes; ++i) advance<dim>(p.of[i], history + i * lanes, material.bulk_terms[k], volume.of[i]);
  }
  return p;
}

/// The dilatational modulus of each cell applied to the volumetric strain of its centre.
template <int dim>
BRECCIA_INLINE Pack dilatational_response(const CellsOfRegister& cells, const Modes<dim>& strain,
                                          const Modes<dim>& increment, double* history) {
  Pack p = cells.of_each(&CellMaterialStep::dilatational) * volume_modes(strain).of[0];
  TermsOfCells terms(cells.of_lane, &CellMaterialStep::dilatational_terms);
  for (int k = 0; k < cells.dilatational_term_count; ++k, history += lanes) {
    advance<dim>(p, history, terms[k], volume_modes(increment).of[0]);
  }
  return p;
}

/// Forces of cells of one material each, with averaged volumetric strains.
template <int dim>
BRECCIA_INLINE Modes<dim> forces_of_cells(const CellMaterials& cells, const Modes<dim>& strain,
                                          const Modes<dim>& increment, int first_lane) {
  const CellsOfRegister of_register = {cells.of_lane + first_lane, cells.shear_term_count,
                                       cells.dilatational_term_count};
  double* history = cells.history + first_lane;
  const Modes<dim> s = shear_response(of_register, strain, increment, history);
  history += cells.shear_term_count * shear_modes<dim> * lanes;
  return forces_of_whole_cells(s, dilatational_response(of_register, strain, increment, history));
}

/// Adds the forces of the points that belong to a share, P' C P of the strain modes: the moduli C have been applied to
/// the modes before, which commutes with the map P of each point.
template <bool averaged, int dim>
BRECCIA_INLINE void add_shared_forces(Modes<dim>& force, const std::uint8_t* points_of_cells, const Modes<dim>& s,
                                      const VolumeModes<dim>& p) {
  Bits points{};
  for (int lane = 0; lane < width; ++lane) points[lane] = points_of_cells[lane];
  for (int point = 0; point < points_of_cell<dim>; ++point) {
    Bits bit{};
    for (int lane = 0; lane < width; ++lane) bit[lane] = 1LL << point;
    const Bits mask = (points & bit) != Bits{};
    const PointMap<dim> at(point);
    Pack deviator[strain_components<dim>];  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
    at.template find_deviator<averaged>(s.of, deviator);
    for (Pack& component : deviator) component = masked(mask, component);
    const Pack pressure = masked(mask, at.template volume<averaged>(p.of));
    at.template add_forces<averaged>(deviator, pressure, force.of);
  }
}

/// Forces on the modes of the cells of one register, times the cell side.
template <bool averaged, int dim>
BRECCIA_INLINE Modes<dim> forces(const CellRow<dim>& row, const Block& block, int cell, int first_lane) {
  const Modes<dim> strain = strain_modes(row.displacement, cell);
  Modes<dim> increment{};
  if (block.relaxes) increment = strain_modes(row.increment, cell);
  if (averaged && block.by_cell != nullptr) return forces_of_cells(*block.by_cell, strain, increment, first_lane);
  Modes<dim> force{};
  for (int i = 0; i < block.share_count; ++i) {
    const Share& share = block.shares[i];
    const MaterialStep& material = *share.material;
    double* shear_history = share.history + first_lane;
    double* bulk_history = shear_history + material.shear_term_count * shear_modes<dim> * lanes;
    const Modes<dim> s = shear_response(material, strain, increment, shear_history);
    const VolumeModes<dim> p = bulk_response<averaged>(material, strain, increment, bulk_history);
    if (block.uniform) {
      force = uniform_forces<averaged>(s, p);
    } else {
      add_shared_forces<averaged>(force, share.points + first_lane, s, p);
    }
  }
  return force;
}

/// The values moved by one lane; the first lane gets the last value of the register before.
template <int... lane>
BRECCIA_INLINE Pack moved_on(const Pack& before, const Pack& values, Lanes<lane...> /*all*/) {
  return __builtin_shufflevector(before, values, (width - 1 + lane)...);
}

/// The forces of the cells to the left of the nodes of a register, which the work on the previous register has left.
template <int dim>
struct ForcesBefore {
  // NOLINTNEXTLINE(modernize-avoid-c-arrays): nothing of the standard library here
  Pack right[axis_count<dim>][rows_of_nodes<dim>];
};

/// Gives the nodes of a register the forces of the cells on both of their sides.
template <int dim>
BRECCIA_INLINE void store_forces(const Modes<dim>& f, const CellRow<dim>& row, int cell, ForcesBefore<dim>& before) {
  using All = typename LanesUpTo<width>::Type;
  for (int c = 0; c < dim; ++c) {
    NodeForces of_rows[rows_of_nodes<dim>];  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
    find_node_forces(f, c, of_rows);
    for (int i = 0; i < rows_of_nodes<dim>; ++i) {
      double* nodes = row.force[i].of_axis[c] + cell;
      const Pack both = of_rows[i].left + moved_on(before.right[c][i], of_rows[i].right, All{});
      store(nodes, adds_to_row<dim>(i) ? load(nodes) + both : both);
      before.right[c][i] = of_rows[i].right;
    }
  }
}

/// Gives the node behind the last cell its force, and the nodes behind that one zero.
template <int dim>
BRECCIA_INLINE void store_last_forces(const CellRow<dim>& row, const ForcesBefore<dim>& before) {
  using All = typename LanesUpTo<width>::Type;
  for (int c = 0; c < dim; ++c) {
    for (int i = 0; i < rows_of_nodes<dim>; ++i) {
      double* nodes = row.force[i].of_axis[c] + row.block_count * lanes;
      const Pack last = moved_on(before.right[c][i], Pack{}, All{});
      store(nodes, adds_to_row<dim>(i) ? load(nodes) + last : last);
    }
  }
}

template <bool averaged, int dim>
void cell_row(const CellRow<dim>& row) {
  LaneSums stress[strain_components<dim>];  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
  ForcesBefore<dim> before{};
  for (int b = 0; b < row.block_count; ++b) {
    if constexpr (!fetches_among_terms) {
      if (row.blocks[b].relaxes) fetch_ahead<dim>(row.blocks[b]);
    }
    for (int part = 0; part < parts; ++part) {
      const int cell = b * lanes + part * width;
      const Modes<dim> force = forces<averaged>(row, row.blocks[b], cell, part * width);
      for (int i = 0; i < strain_components<dim>; ++i) stress[i].add(part, force.of[i]);
      store_forces(force, row, cell, before);
    }
  }
  store_last_forces(row, before);
  for (int i = 0; i < strain_components<dim>; ++i) row.stress[i] = stress[i].total();
}

template <int dim>
void node_row(const NodeRow<dim>& row) {
  for (int node = 0; node < row.count; node += width) {
    const Pack step_over_mass = load(row.step_over_mass + node);
    for (int c = 0; c < dim; ++c) {
      double *u = row.displacement[c] + node, *du = row.increment[c] + node;
      const Pack force = load(row.from_cells_below.of_axis[c] + node) + load(row.from_cells_above.of_axis[c] + node);
      const Pack moved = load(du) + step_over_mass * force;
      store(du, moved);
      store(u, load(u) + moved);
    }
  }
}

template <int dim>
constexpr KernelTable<dim> table = {cell_row<true, dim>, cell_row<false, dim>, node_row<dim>};

}  // namespace

extern const Kernels BRECCIA_KERNELS;
const Kernels BRECCIA_KERNELS = {table<2>, table<3>};

}  // namespace breccia::dynamics
