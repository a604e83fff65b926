#include "quasistatic/operator/elastic_operator.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

#include "breccia/error.hpp"

#include "discretisation/contrast.hpp"
#include "discretisation/gaps/linear_motion.hpp"
#include "discretisation/gaps/plane/square_cells.hpp"
#include "discretisation/gaps/space/cube_cells.hpp"
#include "parallel/threads.hpp"
#include "quasistatic/operator/gap_matrix.hpp"
#include "quasistatic/operator/gap_operator.hpp"
#include "quasistatic/operator/sum_over_cells.hpp"
#include "quasistatic/operator/vector_values.hpp"

namespace breccia::quasistatic {
namespace {

/// Whether all particles are stiffer than the binder between them at all times. Without materials they are taken to be.
template <int dim>
bool are_stiffer(const ParticlesInBox<dim>& particles, std::span<const Material> materials) {
  if (materials.empty()) return true;
  std::vector<Material> in_gaps = {materials[particles.matrix]};
  for (const auto& [phase, coating, thickness] : particles.phases) {
    in_gaps.push_back(materials[phase]);
    if (thickness > 0.0) in_gaps.push_back(materials[coating]);
  }
  return are_stiffer_than_matrix(in_gaps);
}

/// The gaps of a discretisation, where they matter: the particles are stiffer than the binder.
template <int dim>
std::shared_ptr<const gaps::GapCells<dim>> gaps_of(const Discretisation<dim>& discretisation, Boundary boundary,
                                                   std::span<const Material> materials) {
  const auto& particles = discretisation.particles_with_gaps();
  if (particles == nullptr || !are_stiffer(*particles, materials)) return nullptr;
  const auto& grid = discretisation.grid();
  const int cells = grid.cells.front();
  constexpr double of_side = 1e-9;
  const bool is_of_box = std::ranges::count(grid.cells, cells) == dim &&
                         std::abs(cells * grid.cell_side - particles->box.side) <= of_side * particles->box.side;
  if (!is_of_box)
    throw InputError("quasi-static solver: expected particles with gaps in a box of the size of the grid");
  auto found = gaps::find_gap_cells(*particles, cells, boundary);
  return found.unknowns() > 0 ? std::make_shared<const gaps::GapCells<dim>>(std::move(found)) : nullptr;
}

/// The number of threads for so many cells along each axis. A thread of few cells waits for the others for longer than
/// it works: of cubes with 8, 12, 16, 20 and 24 cells a side, two threads solved those with 20 and 24 sooner than one.
template <int dim>
int threads_for(int asked, const Index<dim>& cells) {
  constexpr std::int64_t least = 4000;
  return parallel::threads_for(asked, std::accumulate(cells.begin(), cells.end(), std::int64_t{1}, std::multiplies<>()),
                               least);
}

}  // namespace

template <int dim>
ElasticOperator<dim>::ElasticOperator(const Discretisation<dim>& discretisation, Volumetric volumetric,
                                      Boundary boundary, int threads, const Crystals& crystals,
                                      std::span<const Material> materials)
    : gaps_(gaps_of(discretisation, boundary, materials)),
      nodes_({discretisation.grid().cells, 1.0}, boundary),
      kinds_(discretisation, volumetric, nodes_.cells(), crystals, materials, gaps_.get()),
      threads_(threads_for<dim>(threads, nodes_.cells().size())) {
  find_first_strains();
  if (!has_gaps()) return;
  gap_layout_ = GapLayout(*gaps_, nodes_.own_nodes(), nodes_.cells());
  const auto own = gap_layout_.numbers().first(gap_layout_.own());
  nodes_.append({own.begin(), own.end()});
}

template <int dim>
void ElasticOperator<dim>::find_first_strains() {
  const auto& [begin, end] = nodes_.cells();
  std::size_t strains = 0;
  auto from = begin, to = end;
  first_strain_.push_back(strains);
  for (int plane = begin.back(); plane < end.back(); ++plane) {
    from.back() = plane;
    to.back() = plane + 1;
    for_each_index(from, to, [&](const Index<dim>& cell) {
      if (const auto* mixed = kinds_.mixed_cell(cell)) strains += static_cast<std::size_t>(mixed->unknowns());
    });
    first_strain_.push_back(strains);
  }
}

template <int dim>
template <class Action>
void ElasticOperator<dim>::for_mixed_cells(Action&& action) const {
  for_mixed_cells_of_planes(0, planes(), action);
}

template <int dim>
NodalVector ElasticOperator<dim>::zero_strains_of_phases() const {
  NodalVector phase_strains;
  check(
      VecCreateMPI(PETSC_COMM_WORLD, static_cast<PetscInt>(first_strain_.back()), PETSC_DETERMINE, phase_strains.put()),
      "making strains of phases");
  if (parallel::ranks() > 1) set_natural_indices(natural_indices_of_strains(), phase_strains.get());
  check(VecSet(phase_strains.get(), 0.0), "making strains of phases");
  return phase_strains;
}

template <int dim>
typename CellShape<dim>::ModeValues ElasticOperator<dim>::modes_of(const Index<dim>& cell, const CellValues& u,
                                                                   std::span<const double> of_gaps) const {
  const auto* gap = gap_cell(cell);
  if (gap == nullptr) return modes_ * u;
  const GapOperator<dim> gap_operator(*gap, modes_);
  return gap_operator.strain(gap_operator.unknowns(u, gap_layout_, of_gaps));
}

template <int dim>
typename CellShape<dim>::Values ElasticOperator<dim>::forces_of(const Index<dim>& cell,
                                                                const typename Shape::ModeValues& stress,
                                                                std::span<double> on_gaps) const {
  const auto* gap = gap_cell(cell);
  if (gap == nullptr) return modes_.transpose() * stress;
  const GapOperator<dim> gap_operator(*gap, modes_);
  auto forces = gaps::CellUnknowns<dim>::Zero().eval();
  gap_operator.add_forces_of(stress, forces);
  gap_operator.add_to_gaps(forces, gap_layout_, on_gaps);
  return forces.template head<Shape::dofs>();
}

template <int dim>
std::vector<double> ElasticOperator<dim>::gaps_in_linear_motion(const Eigen::Matrix<double, dim, dim>& gradient) const {
  std::vector<double> values(gap_layout_.seen(), 0.0);
  if (!has_gaps()) return values;
  const auto motion = gaps::linear_motion<dim>(gradient);
  nodes_.for_cells([&](const Index<dim>& cell) {
    const auto* gap = gap_cell(cell);
    if (gap == nullptr) return;
    for (std::size_t k = 0; k < gap->gap_unknowns.size(); ++k) {
      const auto number = gap->gap_unknowns[k];
      if (number == gaps::GapCell<dim>::none) continue;
      values[gap_layout_.index_of(number)] = motion[Shape::dofs + static_cast<Eigen::Index>(k)];
    }
  });
  return values;
}

template <int dim>
Displacement ElasticOperator<dim>::uniform_strain(Load load) const {
  auto displacement = zero();
  const auto strain = unit_strain<dim>(load);
  const auto affine = Shape::affine_motion(strain);
  const WriteValues phase_strains(displacement.phase_strains());
  Eigen::Matrix<double, dim, dim> gradient;
  for (int i = 0; i < dim; ++i) {
    for (int j = 0; j < dim; ++j) gradient(i, j) = component(strain, i, j);
  }
  const auto of_gaps = gaps_in_linear_motion(gradient);
  for_mixed_cells([&](const Index<dim>& cell, const MixedCell<dim>& mixed, std::size_t index) {
    phase_strains.range(index, mixed.unknowns()) = mixed.uniform(modes_of(cell, affine, of_gaps));
  });
  if (boundary() != Boundary::traction) {
    gap_layout_.set(of_gaps, displacement.fluctuation());
    displacement.set_macroscopic(1.0);
    return displacement;
  }
  // The strain is rotated so that the held components are zero: u_i depends on x_j with j >= i alone.
  for (int i = 0; i < dim; ++i) {
    for (int j = i + 1; j < dim; ++j) gradient(i, j) = 2.0 * component(strain, i, j);
    for (int j = 0; j < i; ++j) gradient(i, j) = 0.0;
  }
  gap_layout_.set(gaps_in_linear_motion(gradient), displacement.fluctuation());
  nodes_.for_nodes(displacement.fluctuation(), [&](const Index<dim>& node, double* u) {
    for (int i = 0; i < dim; ++i) {
      u[i] = component(strain, i) * node[static_cast<std::size_t>(i)];
      for (int j = i + 1; j < dim; ++j) u[i] += 2.0 * component(strain, i, j) * node[static_cast<std::size_t>(j)];
    }
  });
  return displacement;
}

template <int dim>
Forces ElasticOperator<dim>::load_forces(Load load) const {
  if (boundary() != Boundary::traction) {
    auto forces = zero();
    forces.set_macroscopic(1.0);
    return forces;
  }
  // The nodal forces of the traction of a uniform stress do the work of that stress on the mean strains of the cells.
  const auto unit = unit_stress<dim>(load);
  typename Shape::StrainVector stress;
  for (int i = 0; i < Shape::strains; ++i) stress[i] = component(unit, i);
  CellValues of_cell = CellValues::Zero();
  for (int p = 0; p < Shape::points; ++p) of_cell += Shape::strain_matrix(p).transpose() * stress / Shape::points;
  auto [macroscopic, on_nodes] = sum_over_cells(nodes_, [&](const Index<dim>&) { return std::pair(of_cell, 0.0); });
  return {macroscopic, std::move(on_nodes), zero_strains_of_phases()};
}

template <int dim>
void ElasticOperator<dim>::condense(std::span<const Moduli> moduli, Forces& forces) const {
  for (const auto& mixed : kinds_.mixed()) {
    if (!mixed) continue;
    const auto& rule = mixed->rule();
    if (rule.in_series(rule.template constrained<dim>(moduli)).minCoeff() > 0.0) continue;
    throw InputError("quasi-static solver: a phase of a mixed cell has a modulus of 0; expected positive ones");
  }
  const ReadValues on_strains(forces.phase_strains());
  std::size_t index = 0;
  std::vector<double> on_gaps(gap_layout_.seen(), 0.0);
  const auto relief = sum_over_cells(nodes_, [&](const Index<dim>& cell) {
    const auto* mixed = kinds_.mixed_cell(cell);
    if (mixed == nullptr) return std::pair<CellValues, double>(CellValues::Zero(), 0.0);
    const auto stress = mixed->stress_relieved_by(moduli, on_strains.range(index, mixed->unknowns()));
    index += static_cast<std::size_t>(mixed->unknowns());
    return std::pair<CellValues, double>(forces_of(cell, stress, on_gaps), 0.0);
  });
  gap_layout_.add(std::move(on_gaps), relief.on_nodes.get());
  check(VecAXPY(forces.fluctuation(), 1.0, relief.on_nodes.get()), "adding nodal forces");
}

template <int dim>
void ElasticOperator<dim>::recover_phase_strains(std::span<const Moduli> moduli, const Forces& forces,
                                                 Displacement& displacement) const {
  const auto local = nodes_.local_copy(displacement.fluctuation());
  const auto of_gaps = gap_layout_.values(displacement.fluctuation());
  const ReadValues values(local.get()), on_strains(forces.phase_strains());
  const WriteValues strains(displacement.phase_strains());
  for_mixed_cells([&](const Index<dim>& cell, const MixedCell<dim>& mixed, std::size_t index) {
    const auto strain = modes_of(cell, nodes_.cell_values(cell, values.data()), of_gaps);
    strains.range(index, mixed.unknowns()) =
        mixed.strains_under(moduli, strain, on_strains.range(index, mixed.unknowns()));
  });
}

/// The indices of the strains of this process among those of all mixed cells, in the order of the cells.
template <int dim>
std::vector<PetscInt> ElasticOperator<dim>::natural_indices_of_strains() const {
  const auto& cells = nodes_.cells();
  const auto in_row = static_cast<std::size_t>(cells.size().front());
  std::vector<PetscInt> indices(first_strain_.back());
  auto row = kinds_.strains_before_rows().size();
  PetscInt next = 0;
  for_mixed_cells([&](const Index<dim>& cell, const MixedCell<dim>& mixed, std::size_t index) {
    const auto row_of_cell = cells.place_of(cell) / in_row;
    if (row_of_cell != row) next = kinds_.strains_before_rows()[row_of_cell];
    row = row_of_cell;
    const auto own = std::span(indices).subspan(index, static_cast<std::size_t>(mixed.unknowns()));
    std::iota(own.begin(), own.end(), next);
    next += static_cast<PetscInt>(mixed.unknowns());
  });
  return indices;
}

template <int dim>
Matrix ElasticOperator<dim>::make_matrix() const {
  if (has_gaps()) return make_gap_matrix(*this);
  return nodes_.make_matrix();
}

template <int dim>
void ElasticOperator<dim>::assemble(std::span<const Moduli> moduli, Mat matrix) const {
  constexpr const char* what = "assembling the stiffness matrix";
  double stiffest = 0.0;
  for (const auto& [bulk, shear] : moduli) stiffest = std::max(stiffest, bulk + shear);
  check(MatZeroEntries(matrix), what);
  if (has_gaps()) return assemble_gap_matrix(*this, moduli, stiffest, matrix);
  const auto by_kind = kinds_.stiffnesses(moduli);
  nodes_.for_cells([&](const Index<dim>& cell) {
    const CellValues free = nodes_.held_mask(cell);
    typename Shape::Stiffness stiffness = free.asDiagonal() * by_kind[kinds_.of(cell)] * free.asDiagonal();
    stiffness.diagonal() += stiffest * (CellValues::Ones() - free);
    nodes_.add_to_matrix(cell, stiffness, matrix);
  });
  check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY), what);
  check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY), what);
}

template class ElasticOperator<2>;
template class ElasticOperator<3>;

}  // namespace breccia::quasistatic
