#include "operator/elastic_operator.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "breccia/error.hpp"
#include "breccia/parallel/threads.hpp"

#include "operator/vector_values.hpp"

namespace breccia::quasistatic {
template <int dim>
ElasticOperator<dim>::ElasticOperator(const Discretisation<dim>& discretisation, Volumetric volumetric,
                                      Boundary boundary, int threads)
    : nodes_({discretisation.grid().cells, 1.0}, boundary),
      volumetric_(volumetric),
      threads_(parallel::threads_for(threads)) {
  find_kinds(discretisation);
  find_first_strains();
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
      if (const auto* mixed = mixed_cell(cell)) strains += static_cast<std::size_t>(mixed->unknowns());
    });
    first_strain_.push_back(strains);
  }
}

template <int dim>
void ElasticOperator<dim>::find_kinds(const Discretisation<dim>& discretisation) {
  const auto& own = nodes_.cells();
  std::map<CellPhases<dim>, std::uint32_t> known;
  PetscInt strains = 0;  // of the cells before
  grid().for_each_cell([&](const Index<dim>& cell) {
    const auto& phases = discretisation.cell(cell);
    if (std::find(phases.begin(), phases.end(), no_phase) != phases.end()) {
      throw InputError("quasi-static solver: a point has no material; empty cells are for the dynamic method");
    }
    const auto* mixture = discretisation.mixture(phases.front());
    if (own.contains(cell)) {
      if (cell.front() == own.begin.front()) first_strain_of_row_.push_back(strains);
      const auto [kind, is_new] = known.emplace(phases, static_cast<std::uint32_t>(known.size()));
      if (is_new) {
        kinds_.push_back(phases);
        mixed_.push_back(mixture != nullptr ? std::optional<MixedCell<dim>>(*mixture) : std::nullopt);
      }
      kind_of_.push_back(kind->second);
    }
    if (mixture != nullptr) strains += static_cast<PetscInt>(MixedCell<dim>::unknowns_of(*mixture));
  });
  if (volumetric_ == Volumetric::standard && !discretisation.mixtures().empty()) {
    throw InputError("quasi-static solver: expected averaged volumetric strains, which mixed cells have");
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
Displacement ElasticOperator<dim>::uniform_strain(Load load) const {
  auto displacement = zero();
  const auto strain = unit_strain<dim>(load);
  const typename Shape::ModeValues of_cell = modes_ * Shape::affine_motion(strain);
  const WriteValues phase_strains(displacement.phase_strains());
  for_mixed_cells([&](const Index<dim>&, const MixedCell<dim>& mixed, std::size_t index) {
    phase_strains.range(index, mixed.unknowns()) = mixed.uniform(of_cell);
  });
  if (boundary() != Boundary::traction) {
    displacement.set_macroscopic(1.0);
    return displacement;
  }
  // Rotated so that the held components are zero: u_i depends on x_j with j >= i alone.
  nodes_.for_nodes(displacement.fluctuation(), [&](const Index<dim>& node, double* u) {
    for (int i = 0; i < dim; ++i) {
      u[i] = component(strain, i) * node[static_cast<std::size_t>(i)];
      for (int j = i + 1; j < dim; ++j) u[i] += 2.0 * component(strain, i, j) * node[static_cast<std::size_t>(j)];
    }
  });
  return displacement;
}

template <int dim>
std::vector<typename CellShape<dim>::Stiffness> ElasticOperator<dim>::stiffnesses(
    std::span<const Moduli> moduli) const {
  std::vector<typename Shape::Stiffness> by_kind;
  by_kind.reserve(kinds_.size());
  for (std::size_t kind = 0; kind < kinds_.size(); ++kind) by_kind.push_back(stiffness_of(kind, moduli));
  return by_kind;
}

template <int dim>
typename CellShape<dim>::Stiffness ElasticOperator<dim>::stiffness_of(std::size_t kind,
                                                                      std::span<const Moduli> moduli) const {
  typename Shape::PointModuli of_points{};
  if (mixed_[kind]) {
    of_points.fill(series_moduli<dim>(mixed_[kind]->mixture(), moduli));
  } else {
    for (std::size_t p = 0; p < of_points.size(); ++p) of_points[p] = moduli[kinds_[kind][p]];
  }
  return Shape::stiffness(of_points, volumetric_);
}

/// Sums what cell_forces(cell) returns for each cell: the forces on its nodes and their work on the macroscopic part.
template <int dim>
template <class CellForces>
typename ElasticOperator<dim>::SumOverCells ElasticOperator<dim>::sum_over_cells(const CellForces& cell_forces) const {
  const auto local = nodes_.local_zeros();
  double macroscopic = 0.0;
  {
    const WriteValues values(local.get());
    nodes_.for_cells([&](const Index<dim>& cell) {
      const auto forces = cell_forces(cell);
      macroscopic += forces.second;
      nodes_.add_to_cell(cell, forces.first, values.data());
    });
  }
  auto on_nodes = nodes_.zeros();
  nodes_.sum_up(local.get(), on_nodes.get());
  MPI_Allreduce(MPI_IN_PLACE, &macroscopic, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return {macroscopic, std::move(on_nodes)};
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
  auto [macroscopic, on_nodes] = sum_over_cells([&](const Index<dim>&) { return std::pair(of_cell, 0.0); });
  return {macroscopic, std::move(on_nodes), zero_strains_of_phases()};
}

template <int dim>
Forces ElasticOperator<dim>::forces(std::span<const Moduli> moduli, Load load, const Displacement& displacement) const {
  if constexpr (dim == 3) return forces_by_rows(moduli, load, displacement);
  const auto by_kind = stiffnesses(moduli);
  const CellValues unit = Shape::affine_motion(unit_strain<dim>(load));
  const CellValues affine = displacement.macroscopic() * unit;
  // The force conjugate to the macroscopic part is (E x)' k u = (k E x)' u, since the stiffness k of a cell is
  // symmetric.
  std::vector<CellValues> conjugate;
  conjugate.reserve(by_kind.size());
  for (const auto& stiffness : by_kind) conjugate.emplace_back(stiffness * unit);
  const auto local = nodes_.local_copy(displacement.fluctuation());
  const ReadValues values(local.get()), strains(displacement.phase_strains());
  const typename Shape::ModeValues unit_modes = modes_ * unit;
  std::vector<double> on_strains;
  auto [macroscopic, on_nodes] = sum_over_cells([&](const Index<dim>& cell) {
    const CellValues u = affine + nodes_.cell_values(cell, values.data());
    const auto kind = kind_of_cell(cell);
    const auto& mixed = mixed_[kind];
    if (!mixed) return std::pair<CellValues, double>(by_kind[kind] * u, conjugate[kind].dot(u));
    const auto [stress, forces] =
        mixed->stresses(moduli, modes_ * u, strains.range(on_strains.size(), mixed->unknowns()));
    on_strains.insert(on_strains.end(), forces.begin(), forces.end());
    return std::pair<CellValues, double>(modes_.transpose() * stress, unit_modes.dot(stress));
  });
  auto on_phase_strains = zero_strains_of_phases();
  std::ranges::copy(on_strains, WriteValues(on_phase_strains.get()).data());
  return {macroscopic, std::move(on_nodes), std::move(on_phase_strains)};
}

template <int dim>
std::optional<Moduli> ElasticOperator<dim>::uniform_moduli(std::size_t kind, std::span<const Moduli> moduli) const {
  if (mixed_[kind]) return series_moduli<dim>(mixed_[kind]->mixture(), moduli);
  const auto& phases = kinds_[kind];
  const bool is_uniform = std::ranges::count(phases, phases.front()) == Shape::points;
  if (!is_uniform || volumetric_ == Volumetric::standard) return std::nullopt;
  return moduli[phases.front()];
}

/// The moduli of the cells of this process; of_kind(kind) gives those of a kind of cells of one material or mixture.
template <int dim>
template <class OfKind>
CellModuli ElasticOperator<dim>::collect_cells(std::span<const Moduli> moduli, const OfKind& of_kind) const {
  constexpr auto none = static_cast<std::uint32_t>(-1);
  CellModuli cells;
  std::vector<std::uint32_t> other;  // index among the stiffnesses of the other cells, by kind
  for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
    const auto same = of_kind(kind);
    const auto [bulk, shear] = same.value_or(Moduli{.bulk = 0.0, .shear = 0.0});
    cells.shear.push_back(shear);
    cells.bulk.push_back(bulk);
    other.push_back(same ? none : static_cast<std::uint32_t>(cells.stiffnesses.size()));
    if (!same) cells.stiffnesses.push_back(stiffness_of(kind, moduli));
  }
  const auto& begin = nodes_.cells().begin;
  const auto size = nodes_.cells().size();
  const auto row = static_cast<std::size_t>(size[0]);
  cells.kind_of = {kind_of_.data(), row, row * static_cast<std::size_t>(size[1])};
  if (cells.stiffnesses.empty()) return cells;
  nodes_.for_cells([&](const Index<dim>& cell) {
    const auto kind = kind_of_cell(cell);
    if (other[kind] == none) return;
    auto among_own = cell;
    for (std::size_t axis = 0; axis < among_own.size(); ++axis) among_own[axis] -= begin[axis];
    cells.others.push_back({among_own, other[kind]});
  });
  return cells;
}

template <int dim>
template <int space>
CellModuli ElasticOperator<dim>::condensed_cells(std::span<const Moduli> moduli) const requires(space == 3) {
  return collect_cells(moduli, [&](std::size_t kind) { return uniform_moduli(kind, moduli); });
}

/// The forces in 3 dimensions: those of all cells but the mixed ones row by row, then those of the mixed cells. What is
/// not needed any longer is given back on the way, for memory is short where this is called.
template <int dim>
template <int space>
Forces ElasticOperator<dim>::forces_by_rows(std::span<const Moduli> moduli, Load load,
                                            const Displacement& displacement) const requires(space == 3) {
  const auto strain = unit_strain<dim>(load);
  std::optional<HaloField> moved(std::in_place, nodes_, threads_), exerted;
  moved->read(nodes_, displacement.fluctuation(), displacement.macroscopic(), strain);
  exerted.emplace(nodes_, threads_);

  const auto cells = collect_cells(moduli, [&](std::size_t kind) {
    return mixed_[kind] ? std::optional<Moduli>(Moduli{.bulk = 0.0, .shear = 0.0}) : uniform_moduli(kind, moduli);
  });
  Index<dim> along{};
  const auto& [begin, end] = nodes_.cells();
  for (std::size_t axis = 0; axis < along.size(); ++axis) along[axis] = end[axis] - begin[axis];
  const CellSweep sweep(along, moved->arrays());
  const auto first = moved->index_of(begin);
  sweep.add_forces(cells, std::as_const(*moved).from(first), exerted->from(first), threads_);
  auto on_phase_strains = zero_strains_of_phases();
  add_mixed_forces(moduli, displacement, sweep, *moved, *exerted, on_phase_strains.get());
  moved.reset();

  double macroscopic = exerted->work_on(strain);
  MPI_Allreduce(MPI_IN_PLACE, &macroscopic, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  auto on_nodes = nodes_.zeros();
  exerted->sum_up(nodes_, on_nodes.get());
  return {macroscopic, std::move(on_nodes), std::move(on_phase_strains)};
}

/// Adds the forces of the mixed cells on their nodes, and sets those on the strains of their phases.
template <int dim>
template <int space>
void ElasticOperator<dim>::add_mixed_forces(std::span<const Moduli> moduli, const Displacement& displacement,
                                            const CellSweep& sweep, const HaloField& moved, HaloField& exerted,
                                            Vec on_phase_strains) const requires(space == 3) {
  const ReadValues strains(displacement.phase_strains());
  const WriteValues on_strains(on_phase_strains);
  const auto displacements = moved.from(0);
  const auto forces_on = exerted.from(0);
  sweep.for_slabs(threads_, [&](int, int first_plane, int end_plane) {
    for_mixed_cells_of_planes(
        first_plane, end_plane, [&](const Index<dim>& cell, const MixedCell<dim>& mixed, std::size_t index) {
          std::array<std::size_t, Shape::nodes> nodes{};
          CellValues u;
          for (std::size_t n = 0; n < nodes.size(); ++n) {
            auto node = Shape::corner(static_cast<int>(n));
            for (std::size_t axis = 0; axis < node.size(); ++axis) node[axis] += cell[axis];
            nodes[n] = moved.index_of(node);
            for (std::size_t i = 0; i < dim; ++i)
              u[static_cast<Eigen::Index>(dim * n + i)] = displacements[i][nodes[n]];
          }
          const auto [stress, on_phases] = mixed.stresses(moduli, modes_ * u, strains.range(index, mixed.unknowns()));
          on_strains.range(index, mixed.unknowns()) = on_phases;
          const CellValues forces = modes_.transpose() * stress;
          for (std::size_t n = 0; n < nodes.size(); ++n) {
            for (std::size_t i = 0; i < dim; ++i) {
              forces_on[i][nodes[n]] += forces[static_cast<Eigen::Index>(dim * n + i)];
            }
          }
        });
  });
}

template <int dim>
void ElasticOperator<dim>::condense(std::span<const Moduli> moduli, Forces& forces) const {
  for (const auto& mixed : mixed_) {
    if (!mixed) continue;
    const auto [bulk, shear] = series_moduli<dim>(mixed->mixture(), moduli);
    if (bulk > 0.0 && shear > 0.0) continue;
    throw InputError("quasi-static solver: a phase of a mixed cell has a modulus of 0; expected positive ones");
  }
  const ReadValues on_strains(forces.phase_strains());
  std::size_t index = 0;
  const auto relief = sum_over_cells([&](const Index<dim>& cell) {
    const auto* mixed = mixed_cell(cell);
    if (mixed == nullptr) return std::pair<CellValues, double>(CellValues::Zero(), 0.0);
    const auto stress = mixed->stress_relieved_by(moduli, on_strains.range(index, mixed->unknowns()));
    index += static_cast<std::size_t>(mixed->unknowns());
    return std::pair<CellValues, double>(modes_.transpose() * stress, 0.0);
  });
  check(VecAXPY(forces.fluctuation(), 1.0, relief.on_nodes.get()), "adding nodal forces");
}

template <int dim>
void ElasticOperator<dim>::recover_phase_strains(std::span<const Moduli> moduli, const Forces& forces,
                                                 Displacement& displacement) const {
  const auto local = nodes_.local_copy(displacement.fluctuation());
  const ReadValues values(local.get()), on_strains(forces.phase_strains());
  const WriteValues strains(displacement.phase_strains());
  for_mixed_cells([&](const Index<dim>& cell, const MixedCell<dim>& mixed, std::size_t index) {
    strains.range(index, mixed.unknowns()) = mixed.strains_under(
        moduli, modes_ * nodes_.cell_values(cell, values.data()), on_strains.range(index, mixed.unknowns()));
  });
}

/// The indices of the strains of this process among those of all mixed cells, in the order of the cells.
template <int dim>
std::vector<PetscInt> ElasticOperator<dim>::natural_indices_of_strains() const {
  const auto& cells = nodes_.cells();
  const auto in_row = static_cast<std::size_t>(cells.size().front());
  std::vector<PetscInt> indices(first_strain_.back());
  auto row = first_strain_of_row_.size();
  PetscInt next = 0;
  for_mixed_cells([&](const Index<dim>& cell, const MixedCell<dim>& mixed, std::size_t index) {
    const auto row_of_cell = cells.place_of(cell) / in_row;
    if (row_of_cell != row) next = first_strain_of_row_[row_of_cell];
    row = row_of_cell;
    const auto own = std::span(indices).subspan(index, static_cast<std::size_t>(mixed.unknowns()));
    std::iota(own.begin(), own.end(), next);
    next += static_cast<PetscInt>(mixed.unknowns());
  });
  return indices;
}

template <int dim>
void ElasticOperator<dim>::assemble(std::span<const Moduli> moduli, Mat matrix) const {
  constexpr const char* what = "assembling the stiffness matrix";
  double stiffest = 0.0;
  for (const auto& [bulk, shear] : moduli) stiffest = std::max(stiffest, bulk + shear);
  const auto by_kind = stiffnesses(moduli);
  check(MatZeroEntries(matrix), what);
  nodes_.for_cells([&](const Index<dim>& cell) {
    const CellValues free = nodes_.held_mask(cell);
    typename Shape::Stiffness stiffness = free.asDiagonal() * by_kind[kind_of_cell(cell)] * free.asDiagonal();
    stiffness.diagonal() += stiffest * (CellValues::Ones() - free);
    nodes_.add_to_matrix(cell, stiffness, matrix);
  });
  check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY), what);
  check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY), what);
}

template class ElasticOperator<2>;
template class ElasticOperator<3>;
template CellModuli ElasticOperator<3>::condensed_cells<3>(std::span<const Moduli>) const;

}  // namespace breccia::quasistatic
