#include "operator/elastic_operator.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <petscdmda.h>

#include "breccia/error.hpp"

#include "operator/read_values.hpp"

namespace breccia::quasistatic {
namespace {

/// Read access to the values of a local vector.
class Values {
 public:
  explicit Values(Vec vector) : values_(vector) {}
  /// `count` values, beginning at a place.
  template <int count>
  [[nodiscard]] Eigen::Map<const Eigen::Matrix<double, count, 1>> at(int place) const noexcept {
    return Eigen::Map<const Eigen::Matrix<double, count, 1>>(values_.data() + place);
  }
  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> range(std::size_t place, Eigen::Index count) const noexcept {
    return {values_.data() + place, count};
  }

 private:
  ReadValues values_;
};

/// Write access to the values of a vector.
class WritableValues {
 public:
  explicit WritableValues(Vec vector) : vector_(vector) { check(VecGetArray(vector_, &data_), "writing values"); }
  WritableValues(const WritableValues&) = delete;
  WritableValues& operator=(const WritableValues&) = delete;
  WritableValues(WritableValues&&) = delete;
  WritableValues& operator=(WritableValues&&) = delete;
  ~WritableValues() { VecRestoreArray(vector_, &data_); }
  [[nodiscard]] Eigen::Map<Eigen::VectorXd> range(std::size_t place, Eigen::Index count) const noexcept {
    return {data_ + place, count};
  }

 private:
  Vec vector_;
  double* data_ = nullptr;
};

NodalVector local_copy(DM nodes, Vec values) {
  NodalVector local;
  check(DMCreateLocalVector(nodes, local.put()), "making a nodal vector");
  check(DMGlobalToLocal(nodes, values, INSERT_VALUES, local.get()), "exchanging nodal values");
  return local;
}

/// All values of a vector, on the first process; empty on the others.
std::vector<double> on_first_process(Vec distributed) {
  constexpr const char* what = "gathering values";
  NodalVector on_first;
  Scatter scatter;
  check(VecScatterCreateToZero(distributed, scatter.put(), on_first.put()), what);
  check(VecScatterBegin(scatter.get(), distributed, on_first.get(), INSERT_VALUES, SCATTER_FORWARD), what);
  check(VecScatterEnd(scatter.get(), distributed, on_first.get(), INSERT_VALUES, SCATTER_FORWARD), what);
  PetscInt count = 0;
  check(VecGetLocalSize(on_first.get(), &count), what);
  const double* values = nullptr;
  check(VecGetArrayRead(on_first.get(), &values), what);
  std::vector<double> all(values, values + count);
  check(VecRestoreArrayRead(on_first.get(), &values), what);
  return all;
}

/// Number of a place in a box of places, the first axis fastest.
template <int dim>
int place_in(const Index<dim>& index, const Index<dim>& begin, const Index<dim>& end) noexcept {
  int place = 0;
  for (std::size_t axis = index.size(); axis-- > 0;) {
    place = place * (end[axis] - begin[axis]) + index[axis] - begin[axis];
  }
  return place;
}

template <int dim>
Index<dim> sum(Index<dim> index, const Index<dim>& other) noexcept {
  for (std::size_t axis = 0; axis < index.size(); ++axis) index[axis] += other[axis];
  return index;
}

}  // namespace

template <int dim>
ElasticOperator<dim>::ElasticOperator(const Discretisation<dim>& discretisation, Volumetric volumetric,
                                      Boundary boundary)
    : grid_{discretisation.grid().cells, 1.0}, volumetric_(volumetric), boundary_(boundary) {
  parallel::start();
  find_kinds(discretisation);
  distribute_nodes();
}

template <int dim>
void ElasticOperator<dim>::find_kinds(const Discretisation<dim>& discretisation) {
  std::map<CellPhases<dim>, std::uint32_t> known;
  kind_of_.reserve(discretisation.cells().size());
  for (const auto& cell : discretisation.cells()) {
    if (std::find(cell.begin(), cell.end(), no_phase) != cell.end()) {
      throw InputError("quasi-static solver: a point has no material; empty cells are for the dynamic method");
    }
    const auto [kind, is_new] = known.emplace(cell, static_cast<std::uint32_t>(known.size()));
    if (is_new) {
      kinds_.push_back(cell);
      const auto* mixture = discretisation.mixture(cell.front());
      mixed_.push_back(mixture != nullptr ? std::optional<MixedCell<dim>>(*mixture) : std::nullopt);
    }
    kind_of_.push_back(kind->second);
  }
  if (volumetric_ == Volumetric::standard && !discretisation.mixtures().empty()) {
    throw InputError("quasi-static solver: expected averaged volumetric strains, which mixed cells have");
  }
}

template <int dim>
Index<dim> ElasticOperator<dim>::nodes_along() const noexcept {
  return boundary_ == Boundary::periodic ? grid_.cells : grid_.nodes();
}

template <int dim>
void ElasticOperator<dim>::distribute_nodes() {
  constexpr const char* what = "distributing the nodes over the processes";
  const auto end = boundary_ == Boundary::periodic ? DM_BOUNDARY_PERIODIC : DM_BOUNDARY_NONE;
  std::array<PetscInt, 3> sizes = {1, 1, 1};
  std::ranges::copy(nodes_along(), sizes.begin());
  check(DMDACreate(PETSC_COMM_WORLD, nodes_.put()), what);
  check(DMSetDimension(nodes_.get(), dim), what);
  check(DMDASetSizes(nodes_.get(), sizes[0], sizes[1], sizes[2]), what);
  check(DMDASetBoundaryType(nodes_.get(), end, end, dim > 2 ? end : DM_BOUNDARY_NONE), what);
  check(DMDASetDof(nodes_.get(), dim), what);
  check(DMDASetStencilType(nodes_.get(), DMDA_STENCIL_BOX), what);
  check(DMDASetStencilWidth(nodes_.get(), 1), what);
  check(DMSetUp(nodes_.get()), what);

  const auto range = [&](auto&& corners) {
    std::array<PetscInt, 3> begin{}, size{};
    check(corners(nodes_.get(), &begin[0], &begin[1], &begin[2], &size[0], &size[1], &size[2]), what);
    Range nodes;
    for (std::size_t axis = 0; axis < dim; ++axis) {
      nodes.begin[axis] = begin[axis];
      nodes.end[axis] = begin[axis] + size[axis];
    }
    return nodes;
  };
  owned_ = range(DMDAGetCorners);
  seen_ = range(DMDAGetGhostCorners);
  cells_ = owned_;
  for (std::size_t axis = 0; axis < dim; ++axis) cells_.end[axis] = std::min(owned_.end[axis], grid_.cells[axis]);
  for (int node = 0; node < Shape::nodes; ++node) {
    offsets_[static_cast<std::size_t>(node)] =
        place_in<dim>(sum<dim>(seen_.begin, Shape::corner(node)), seen_.begin, seen_.end);
  }
  std::size_t place = 0;
  for_each_index(owned_.begin, owned_.end, [&](const Index<dim>& node) {
    for (int component = 0; component < dim; ++component, ++place) {
      if (is_held(node, component)) held_.push_back(place);
    }
  });
  Eigen::Index strains = 0;
  for_mixed_cells([&](const Index<dim>&, const MixedCell<dim>& mixed, std::size_t) { strains += mixed.unknowns(); });
  check(VecCreateMPI(PETSC_COMM_WORLD, static_cast<PetscInt>(strains), PETSC_DETERMINE, no_phase_strains_.put()), what);
}

template <int dim>
template <class Action>
void ElasticOperator<dim>::for_mixed_cells(Action&& action) const {
  std::size_t place = 0;
  for_each_index(cells_.begin, cells_.end, [&](const Index<dim>& cell) {
    const auto* mixed = mixed_cell(cell);
    if (mixed == nullptr) return;
    action(cell, *mixed, place);
    place += static_cast<std::size_t>(mixed->unknowns());
  });
}

template <int dim>
std::int64_t ElasticOperator<dim>::unknowns() const noexcept {
  std::int64_t unknowns = dim;
  for (const int along : nodes_along()) unknowns *= along;
  return unknowns;
}

template <int dim>
Displacement ElasticOperator<dim>::zero() const {
  NodalVector fluctuation;
  check(DMCreateGlobalVector(nodes_.get(), fluctuation.put()), "making a nodal vector");
  check(VecSet(fluctuation.get(), 0.0), "making a nodal vector");
  NodalVector phase_strains;
  check(VecDuplicate(no_phase_strains_.get(), phase_strains.put()), "making strains of phases");
  check(VecSet(phase_strains.get(), 0.0), "making strains of phases");
  return {0.0, std::move(fluctuation), std::move(phase_strains)};
}

/// Calls action(node, components) for the nodes of this process.
template <int dim>
template <class Action>
void ElasticOperator<dim>::for_owned_nodes(Vec nodal, Action&& action) const {
  constexpr const char* what = "writing nodal values";
  double* values = nullptr;
  check(VecGetArray(nodal, &values), what);
  double* components = values;
  for_each_index(owned_.begin, owned_.end, [&](const Index<dim>& node) {
    action(node, components);
    components += dim;
  });
  check(VecRestoreArray(nodal, &values), what);
}

template <int dim>
Displacement ElasticOperator<dim>::uniform_strain(Load load) const {
  auto displacement = zero();
  const auto strain = unit_strain<dim>(load);
  const typename Shape::ModeValues of_cell = modes_ * Shape::affine_motion(strain);
  const WritableValues phase_strains(displacement.phase_strains());
  for_mixed_cells([&](const Index<dim>&, const MixedCell<dim>& mixed, std::size_t place) {
    phase_strains.range(place, mixed.unknowns()) = mixed.uniform(of_cell);
  });
  if (boundary_ != Boundary::traction) {
    displacement.set_macroscopic(1.0);
    return displacement;
  }
  // Rotated so that the held components are zero: u_i depends on x_j with j >= i alone.
  for_owned_nodes(displacement.fluctuation(), [&](const Index<dim>& node, double* u) {
    for (int i = 0; i < dim; ++i) {
      u[i] = component(strain, i) * node[static_cast<std::size_t>(i)];
      for (int j = i + 1; j < dim; ++j) u[i] += 2.0 * component(strain, i, j) * node[static_cast<std::size_t>(j)];
    }
  });
  return displacement;
}

template <int dim>
bool ElasticOperator<dim>::is_held(const Index<dim>& node, int component) const noexcept {
  const auto is_at_end = [&](std::size_t axis) { return node[axis] == 0 || node[axis] == grid_.cells[axis]; };
  switch (boundary_) {
    case Boundary::displacement: {
      bool is_on_boundary = false;
      for (std::size_t axis = 0; axis < dim; ++axis) is_on_boundary = is_on_boundary || is_at_end(axis);
      return is_on_boundary;
    }
    case Boundary::traction: {
      // The lowest corner is at rest; the corner beyond it along axis d holds the components above d.
      auto corner = node;
      for (std::size_t axis = 0; axis < dim; ++axis) {
        if (corner[axis] != grid_.cells[axis]) continue;
        corner[axis] = 0;
        return corner == Index<dim>{} && component > static_cast<int>(axis);
      }
      return node == Index<dim>{};
    }
    case Boundary::periodic: {
      bool is_corner = true;
      for (std::size_t axis = 0; axis < dim; ++axis) is_corner = is_corner && is_at_end(axis);
      return is_corner;
    }
  }
  return false;
}

/// 0 for the components of a cell's nodes that are held, 1 for the others.
template <int dim>
typename ElasticOperator<dim>::CellValues ElasticOperator<dim>::held_mask(const Index<dim>& cell) const noexcept {
  CellValues free;
  for (int node = 0; node < Shape::nodes; ++node) {
    const auto place = sum<dim>(cell, Shape::corner(node));
    for (int component = 0; component < dim; ++component) {
      free[dim * node + component] = is_held(place, component) ? 0.0 : 1.0;
    }
  }
  return free;
}

/// The fluctuation at the nodes of a cell, from values with those of neighbouring processes.
template <int dim>
template <class LocalValues>
typename ElasticOperator<dim>::CellValues ElasticOperator<dim>::cell_values(const Index<dim>& cell,
                                                                            const LocalValues& values) const noexcept {
  const int lowest = lowest_node_of(cell);
  CellValues u;
  for (int node = 0; node < Shape::nodes; node += 2) {
    u.template segment<2 * dim>(dim * node) =
        values.template at<2 * dim>(dim * (lowest + offsets_[static_cast<std::size_t>(node)]));
  }
  return u;
}

/// Place of the lowest node of a cell among the nodes that this process sees.
template <int dim>
int ElasticOperator<dim>::lowest_node_of(const Index<dim>& cell) const noexcept {
  return place_in<dim>(cell, seen_.begin, seen_.end);
}

template <int dim>
std::vector<typename CellShape<dim>::Stiffness> ElasticOperator<dim>::stiffnesses(
    std::span<const Moduli> moduli) const {
  std::vector<typename Shape::Stiffness> by_kind;
  by_kind.reserve(kinds_.size());
  for (const auto& kind : kinds_) {
    typename Shape::PointModuli of_points{};
    const auto& mixed = mixed_[by_kind.size()];
    if (mixed) {
      of_points.fill(series_moduli(mixed->mixture(), moduli));
    } else {
      for (std::size_t p = 0; p < of_points.size(); ++p) of_points[p] = moduli[kind[p]];
    }
    by_kind.push_back(Shape::stiffness(of_points, volumetric_));
  }
  return by_kind;
}

/// Sets the held components to zero.
template <int dim>
void ElasticOperator<dim>::clear_held(Vec nodal) const {
  double* values = nullptr;
  check(VecGetArray(nodal, &values), "writing nodal values");
  for (const auto place : held_) values[place] = 0.0;
  check(VecRestoreArray(nodal, &values), "writing nodal values");
}

/// Sums what cell_forces(cell) returns for each cell: the forces on its nodes and their work on the macroscopic part.
template <int dim>
template <class CellForces>
Forces ElasticOperator<dim>::sum_over_cells(const CellForces& cell_forces) const {
  NodalVector local;
  check(DMCreateLocalVector(nodes_.get(), local.put()), "making a nodal vector");
  check(VecSet(local.get(), 0.0), "making a nodal vector");
  double* values = nullptr;
  check(VecGetArray(local.get(), &values), "writing nodal values");
  double macroscopic = 0.0;
  for_each_index(cells_.begin, cells_.end, [&](const Index<dim>& cell) {
    const auto forces = cell_forces(cell);
    macroscopic += forces.second;
    // The nodes of a cell come in pairs that are neighbours along the first axis.
    const int lowest = lowest_node_of(cell);
    for (int node = 0; node < Shape::nodes; node += 2) {
      Eigen::Map<Eigen::Matrix<double, 2 * dim, 1>>(values +
                                                    dim * (lowest + offsets_[static_cast<std::size_t>(node)])) +=
          forces.first.template segment<2 * dim>(dim * node);
    }
  });
  check(VecRestoreArray(local.get(), &values), "writing nodal values");
  auto sum = zero();
  check(DMLocalToGlobal(nodes_.get(), local.get(), ADD_VALUES, sum.fluctuation()), "adding nodal forces");
  clear_held(sum.fluctuation());
  MPI_Allreduce(MPI_IN_PLACE, &macroscopic, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  sum.set_macroscopic(macroscopic);
  return sum;
}

template <int dim>
Forces ElasticOperator<dim>::load_forces(Load load) const {
  auto forces = zero();
  if (boundary_ != Boundary::traction) {
    forces.set_macroscopic(1.0);
    return forces;
  }
  // The nodal forces of the traction of a uniform stress do the work of that stress on the mean strains of the cells.
  const auto unit = unit_stress<dim>(load);
  typename Shape::StrainVector stress;
  for (int place = 0; place < Shape::strains; ++place) stress[place] = component(unit, place);
  CellValues of_cell = CellValues::Zero();
  for (int p = 0; p < Shape::points; ++p) of_cell += Shape::strain_matrix(p).transpose() * stress / Shape::points;
  return sum_over_cells([&](const Index<dim>&) { return std::pair(of_cell, 0.0); });
}

template <int dim>
Forces ElasticOperator<dim>::forces(std::span<const Moduli> moduli, Load load, const Displacement& displacement) const {
  const auto by_kind = stiffnesses(moduli);
  const CellValues unit = Shape::affine_motion(unit_strain<dim>(load));
  const CellValues affine = displacement.macroscopic() * unit;
  // The force conjugate to the macroscopic part is (E x)' k u = (k E x)' u, since the stiffness k of a cell is
  // symmetric.
  std::vector<CellValues> conjugate;
  conjugate.reserve(by_kind.size());
  for (const auto& stiffness : by_kind) conjugate.emplace_back(stiffness * unit);
  const auto local = local_copy(nodes_.get(), displacement.fluctuation());
  const Values values(local.get()), strains(displacement.phase_strains());
  auto on_strains = zero();
  const WritableValues forces_on_strains(on_strains.phase_strains());
  const typename Shape::ModeValues unit_modes = modes_ * unit;
  std::size_t place = 0;
  auto sum = sum_over_cells([&](const Index<dim>& cell) {
    const CellValues u = affine + cell_values(cell, values);
    const auto kind = kind_of_cell(cell);
    const auto& mixed = mixed_[kind];
    if (!mixed) return std::pair<CellValues, double>(by_kind[kind] * u, conjugate[kind].dot(u));
    const auto unknowns = mixed->unknowns();
    const auto [stress, forces] = mixed->stresses(moduli, modes_ * u, strains.range(place, unknowns));
    forces_on_strains.range(place, unknowns) = forces;
    place += static_cast<std::size_t>(unknowns);
    return std::pair<CellValues, double>(modes_.transpose() * stress, unit_modes.dot(stress));
  });
  sum.add(1.0, on_strains);
  return sum;
}

template <int dim>
Forces ElasticOperator<dim>::condensed(std::span<const Moduli> moduli, const Forces& forces) const {
  const Values on_strains(forces.phase_strains());
  std::size_t place = 0;
  auto condensed = sum_over_cells([&](const Index<dim>& cell) {
    const auto* mixed = mixed_cell(cell);
    if (mixed == nullptr) return std::pair<CellValues, double>(CellValues::Zero(), 0.0);
    const auto stress = mixed->stress_of(moduli, on_strains.range(place, mixed->unknowns()));
    place += static_cast<std::size_t>(mixed->unknowns());
    return std::pair<CellValues, double>(modes_.transpose() * stress, 0.0);
  });
  check(VecAXPY(condensed.fluctuation(), 1.0, forces.fluctuation()), "adding nodal forces");
  return condensed;
}

template <int dim>
void ElasticOperator<dim>::recover_phase_strains(std::span<const Moduli> moduli, const Forces& forces,
                                                 Displacement& displacement) const {
  const auto local = local_copy(nodes_.get(), displacement.fluctuation());
  const Values values(local.get()), on_strains(forces.phase_strains());
  const WritableValues strains(displacement.phase_strains());
  for_mixed_cells([&](const Index<dim>& cell, const MixedCell<dim>& mixed, std::size_t place) {
    strains.range(place, mixed.unknowns()) =
        mixed.strains_under(moduli, modes_ * cell_values(cell, values), on_strains.range(place, mixed.unknowns()));
  });
}

template <int dim>
std::vector<double> ElasticOperator<dim>::gathered(const Displacement& displacement) const {
  constexpr const char* what = "gathering nodal values";
  NodalVector in_rows;
  check(DMDACreateNaturalVector(nodes_.get(), in_rows.put()), what);
  check(DMDAGlobalToNaturalBegin(nodes_.get(), displacement.fluctuation(), INSERT_VALUES, in_rows.get()), what);
  check(DMDAGlobalToNaturalEnd(nodes_.get(), displacement.fluctuation(), INSERT_VALUES, in_rows.get()), what);
  return on_first_process(in_rows.get());
}

template <int dim>
std::vector<double> ElasticOperator<dim>::gathered_phase_strains(const Displacement& displacement) const {
  // The place of each strain in the list of all cells, which the values of a process follow in parts.
  std::vector<std::size_t> first_of_cell(kind_of_.size());
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < kind_of_.size(); ++cell) {
    first_of_cell[cell] = count;
    const auto& mixed = mixed_[kind_of_[cell]];
    if (mixed) count += static_cast<std::size_t>(mixed->unknowns());
  }
  auto places = zero();
  {
    const WritableValues values(places.phase_strains());
    for_mixed_cells([&](const Index<dim>& cell, const MixedCell<dim>& mixed, std::size_t place) {
      const auto first = static_cast<double>(first_of_cell[grid_.cell_index(cell)]);
      values.range(place, mixed.unknowns()).setLinSpaced(first, first + static_cast<double>(mixed.unknowns() - 1));
    });
  }
  const auto in_parts = on_first_process(displacement.phase_strains()), at = on_first_process(places.phase_strains());
  std::vector<double> all(in_parts.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[static_cast<std::size_t>(std::lround(at[i]))] = in_parts[i];
  return all;
}

template <int dim>
Matrix ElasticOperator<dim>::make_matrix() const {
  Matrix matrix;
  check(DMSetMatType(nodes_.get(), MATAIJ), "making the stiffness matrix");
  check(DMCreateMatrix(nodes_.get(), matrix.put()), "making the stiffness matrix");
  check(MatSetOption(matrix.get(), MAT_SPD, PETSC_TRUE), "making the stiffness matrix");
  return matrix;
}

template <int dim>
void ElasticOperator<dim>::assemble(std::span<const Moduli> moduli, Mat matrix) const {
  constexpr const char* what = "assembling the stiffness matrix";
  double stiffest = 0.0;
  for (const auto& [bulk, shear] : moduli) stiffest = std::max(stiffest, bulk + shear);
  const auto by_kind = stiffnesses(moduli);
  check(MatZeroEntries(matrix), what);
  for_each_index(cells_.begin, cells_.end, [&](const Index<dim>& cell) {
    const CellValues free = held_mask(cell);
    typename Shape::Stiffness stiffness = free.asDiagonal() * by_kind[kind_of_cell(cell)] * free.asDiagonal();
    stiffness.diagonal() += stiffest * (CellValues::Ones() - free);
    auto nodes = offsets_;
    for (int& node : nodes) node += lowest_node_of(cell);
    // Row by row or column by column: it is symmetric.
    check(MatSetValuesBlockedLocal(matrix, Shape::nodes, nodes.data(), Shape::nodes, nodes.data(), stiffness.data(),
                                   ADD_VALUES),
          what);
  });
  check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY), what);
  check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY), what);
}

template <int dim>
void ElasticOperator<dim>::attach_rigid_motions(Mat matrix) const {
  constexpr const char* what = "setting up the rigid motions";
  std::array<double, 3> end{};
  std::ranges::copy(grid_.cells, end.begin());
  check(DMDASetUniformCoordinates(nodes_.get(), 0.0, end[0], 0.0, end[1], 0.0, end[2]), what);
  Vec coordinates = nullptr;
  check(DMGetCoordinates(nodes_.get(), &coordinates), what);
  PetscHandle<MatNullSpace, MatNullSpaceDestroy> rigid_motions;
  check(MatNullSpaceCreateRigidBody(coordinates, rigid_motions.put()), what);
  check(MatSetNearNullSpace(matrix, rigid_motions.get()), what);
}

template class ElasticOperator<2>;
template class ElasticOperator<3>;

}  // namespace breccia::quasistatic
