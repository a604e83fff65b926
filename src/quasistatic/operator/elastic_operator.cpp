#include "operator/elastic_operator.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <petscdmda.h>

#include "breccia/error.hpp"

namespace breccia::quasistatic {
namespace {

/// Read access to the values of a local vector.
class Values {
 public:
  explicit Values(Vec vector) : vector_(vector) { check(VecGetArrayRead(vector_, &data_), "reading nodal values"); }
  Values(const Values&) = delete;
  Values& operator=(const Values&) = delete;
  Values(Values&&) = delete;
  Values& operator=(Values&&) = delete;
  ~Values() { VecRestoreArrayRead(vector_, &data_); }
  /// `count` values, beginning at a place.
  template <int count>
  [[nodiscard]] Eigen::Map<const Eigen::Matrix<double, count, 1>> at(int place) const noexcept {
    return Eigen::Map<const Eigen::Matrix<double, count, 1>>(data_ + place);
  }

 private:
  Vec vector_;
  const double* data_ = nullptr;
};

NodalVector local_copy(DM grid, Vec values) {
  NodalVector local;
  check(DMCreateLocalVector(grid, local.put()), "making a nodal vector");
  check(DMGlobalToLocal(grid, values, INSERT_VALUES, local.get()), "exchanging nodal values");
  return local;
}

}  // namespace

CellVector affine_motion(const PlaneStrain& strain) {
  constexpr std::array<std::array<double, 2>, 4> corners = {{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};
  CellVector motion;
  for (Eigen::Index node = 0; node < 4; ++node) {
    const auto& [x, y] = corners[static_cast<std::size_t>(node)];
    motion[2 * node] = strain.xx * x + strain.xy * y;
    motion[2 * node + 1] = strain.xy * x + strain.yy * y;
  }
  return motion;
}

ElasticOperator::ElasticOperator(const Discretisation& discretisation, Volumetric volumetric, Boundary boundary)
    : columns_(discretisation.grid().columns),
      rows_(discretisation.grid().rows),
      volumetric_(volumetric),
      boundary_(boundary) {
  parallel::start();
  std::map<CellMaterials, std::uint32_t> known;
  kind_of_.reserve(discretisation.cells().size());
  for (const auto& cell : discretisation.cells()) {
    if (std::find(cell.begin(), cell.end(), no_material) != cell.end()) {
      throw InputError("quasi-static solver: a point has no material; empty cells are for the dynamic method");
    }
    const auto [kind, is_new] = known.emplace(cell, static_cast<std::uint32_t>(known.size()));
    if (is_new) kinds_.push_back(cell);
    kind_of_.push_back(kind->second);
  }

  const bool wraps = boundary == Boundary::periodic;
  const auto end = wraps ? DM_BOUNDARY_PERIODIC : DM_BOUNDARY_NONE;
  const int more = wraps ? 0 : 1;
  constexpr int components = 2, neighbours = 1;
  check(DMDACreate2d(PETSC_COMM_WORLD, end, end, DMDA_STENCIL_BOX, columns_ + more, rows_ + more, PETSC_DECIDE,
                     PETSC_DECIDE, components, neighbours, nullptr, nullptr, grid_.put()),
        "making the grid of nodes");
  check(DMSetUp(grid_.get()), "spreading the grid of nodes over the processes");
  int x = 0, y = 0, width = 0, height = 0;
  check(DMDAGetCorners(grid_.get(), &x, &y, nullptr, &width, &height, nullptr), "reading the grid of nodes");
  cells_ = {x, std::min(x + width, columns_), y, std::min(y + height, rows_)};
  check(DMDAGetGhostCorners(grid_.get(), &x, &y, nullptr, &width, &height, nullptr), "reading the grid of nodes");
  patch_ = {x, y, width};
}

std::int64_t ElasticOperator::unknowns() const noexcept {
  const std::int64_t more = boundary_ == Boundary::periodic ? 0 : 1;
  return 2 * (columns_ + more) * (rows_ + more);
}

Displacement ElasticOperator::zero() const {
  NodalVector fluctuation;
  check(DMCreateGlobalVector(grid_.get(), fluctuation.put()), "making a nodal vector");
  check(VecSet(fluctuation.get(), 0.0), "making a nodal vector");
  return {0.0, std::move(fluctuation)};
}

Displacement ElasticOperator::uniform_strain(Load load) const {
  auto displacement = zero();
  if (boundary_ != Boundary::traction) {
    displacement.set_macroscopic(1.0);
    return displacement;
  }
  // Rotated so that the lower side stays on its line, where the held components are zero.
  const auto strain = unit_strain(load);
  constexpr const char* what = "writing nodal values";
  double*** nodes = nullptr;
  int x = 0, y = 0, width = 0, height = 0;
  check(DMDAGetCorners(grid_.get(), &x, &y, nullptr, &width, &height, nullptr), what);
  check(DMDAVecGetArrayDOF(grid_.get(), displacement.fluctuation(), static_cast<void*>(&nodes)), what);
  for (int row = y; row < y + height; ++row) {
    for (int column = x; column < x + width; ++column) {
      nodes[row][column][0] = strain.xx * column + 2.0 * strain.xy * row;
      nodes[row][column][1] = strain.yy * row;
    }
  }
  check(DMDAVecRestoreArrayDOF(grid_.get(), displacement.fluctuation(), static_cast<void*>(&nodes)), what);
  return displacement;
}

bool ElasticOperator::is_held(int column, int row, int component) const noexcept {
  switch (boundary_) {
    case Boundary::displacement:
      return column == 0 || row == 0 || column == columns_ || row == rows_;
    case Boundary::traction:
      return row == 0 && (column == 0 || (column == columns_ && component == 1));
    case Boundary::periodic:
      return column % columns_ == 0 && row % rows_ == 0;
  }
  return false;
}

CellVector ElasticOperator::held_mask(int column, int row) const noexcept {
  CellVector free;
  for (int node = 0; node < 4; ++node) {
    for (int component = 0; component < 2; ++component) {
      free[2 * node + component] = is_held(column + node % 2, row + node / 2, component) ? 0.0 : 1.0;
    }
  }
  return free;
}

std::array<int, 4> ElasticOperator::nodes_of_cell(int column, int row) const noexcept {
  const int first = (row - patch_.first_row) * patch_.columns + column - patch_.first_column;
  return {first, first + 1, first + patch_.columns, first + patch_.columns + 1};
}

std::vector<CellMatrix> ElasticOperator::stiffnesses(std::span<const Moduli> moduli) const {
  std::vector<CellMatrix> by_kind;
  by_kind.reserve(kinds_.size());
  for (const auto& kind : kinds_) {
    std::array<Moduli, points_per_cell> of_points{};
    for (std::size_t p = 0; p < points_per_cell; ++p) of_points[p] = moduli[kind[p]];
    by_kind.push_back(cell_stiffness(of_points, volumetric_));
  }
  return by_kind;
}

/// Sets the components that are held to zero.
void ElasticOperator::clear_held(Vec nodal) const {
  constexpr const char* what = "writing nodal values";
  double*** values = nullptr;
  check(DMDAVecGetArrayDOF(grid_.get(), nodal, static_cast<void*>(&values)), what);
  const auto clear = [&](int column, int row) {
    for (int component = 0; component < 2; ++component) {
      if (is_held(column, row, component)) values[row][column][component] = 0.0;
    }
  };
  // Held components exist on the boundary of the box alone.
  int x = 0, y = 0, width = 0, height = 0;
  check(DMDAGetCorners(grid_.get(), &x, &y, nullptr, &width, &height, nullptr), what);
  for (int row = y; row < y + height; ++row) {
    const int step = row == 0 || row == rows_ ? 1 : columns_;
    for (int column = (x + step - 1) / step * step; column < x + width; column += step) clear(column, row);
  }
  check(DMDAVecRestoreArrayDOF(grid_.get(), nodal, static_cast<void*>(&values)), what);
}

/// Sums what `cell_forces` returns for the column and row of each cell: the forces on its nodes and their work on the
/// macroscopic part.
template <class CellForces>
Forces ElasticOperator::sum_over_cells(const CellForces& cell_forces) const {
  NodalVector local;
  check(DMCreateLocalVector(grid_.get(), local.put()), "making a nodal vector");
  check(VecSet(local.get(), 0.0), "making a nodal vector");
  double* values = nullptr;
  check(VecGetArray(local.get(), &values), "writing nodal values");
  double macroscopic = 0.0;
  for (int row = cells_.first_row; row < cells_.last_row; ++row) {
    for (int column = cells_.first_column; column < cells_.last_column; ++column) {
      const auto [on_nodes, on_macroscopic] = cell_forces(column, row);
      macroscopic += on_macroscopic;
      // The two lower nodes of a cell are adjacent in memory, and so are the two upper ones.
      const int first = nodes_of_cell(column, row).front();
      Eigen::Map<Eigen::Vector4d>(values + 2 * first) += on_nodes.template head<4>();
      Eigen::Map<Eigen::Vector4d>(values + 2 * (first + patch_.columns)) += on_nodes.template tail<4>();
    }
  }
  check(VecRestoreArray(local.get(), &values), "writing nodal values");
  auto sum = zero();
  check(DMLocalToGlobal(grid_.get(), local.get(), ADD_VALUES, sum.fluctuation()), "adding nodal forces");
  clear_held(sum.fluctuation());
  MPI_Allreduce(MPI_IN_PLACE, &macroscopic, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  sum.set_macroscopic(macroscopic);
  return sum;
}

Forces ElasticOperator::load_forces(Load load) const {
  auto forces = zero();
  if (boundary_ != Boundary::traction) {
    forces.set_macroscopic(1.0);
    return forces;
  }
  // The nodal forces of the traction of a uniform stress do the work of that stress on the mean strains of the cells.
  const auto strain = unit_strain(load);
  const Eigen::Vector3d stress(2.0 * strain.xx, 2.0 * strain.yy, 2.0 * strain.xy);
  CellVector of_cell = CellVector::Zero();
  for (int p = 0; p < points_per_cell; ++p) of_cell += strain_matrix(p).transpose() * stress / points_per_cell;
  return sum_over_cells([&](int, int) { return std::pair(of_cell, 0.0); });
}

Forces ElasticOperator::forces(std::span<const Moduli> moduli, Load load, const Displacement& displacement) const {
  const auto by_kind = stiffnesses(moduli);
  const CellVector macroscopic = displacement.macroscopic() * affine_motion(unit_strain(load));
  // The force conjugate to the macroscopic part is (E x)' k u = (k E x)' u, since the stiffness k of a cell is
  // symmetric.
  std::vector<CellVector> conjugate;
  conjugate.reserve(by_kind.size());
  for (const auto& stiffness : by_kind) conjugate.emplace_back(stiffness * affine_motion(unit_strain(load)));
  const auto local = local_copy(grid_.get(), displacement.fluctuation());
  const Values values(local.get());
  return sum_over_cells([&](int column, int row) {
    const auto nodes = nodes_of_cell(column, row);
    CellVector u = macroscopic;
    u.head<4>() += values.at<4>(2 * nodes[0]);
    u.tail<4>() += values.at<4>(2 * nodes[2]);
    const auto kind = kind_of_cell(column, row);
    return std::pair<CellVector, double>(by_kind[kind] * u, conjugate[kind].dot(u));
  });
}

std::vector<double> ElasticOperator::gathered(const Displacement& displacement) const {
  constexpr const char* what = "gathering nodal values";
  NodalVector in_rows, on_first;
  check(DMDACreateNaturalVector(grid_.get(), in_rows.put()), what);
  check(DMDAGlobalToNaturalBegin(grid_.get(), displacement.fluctuation(), INSERT_VALUES, in_rows.get()), what);
  check(DMDAGlobalToNaturalEnd(grid_.get(), displacement.fluctuation(), INSERT_VALUES, in_rows.get()), what);
  PetscHandle<VecScatter, VecScatterDestroy> scatter;
  check(VecScatterCreateToZero(in_rows.get(), scatter.put(), on_first.put()), what);
  check(VecScatterBegin(scatter.get(), in_rows.get(), on_first.get(), INSERT_VALUES, SCATTER_FORWARD), what);
  check(VecScatterEnd(scatter.get(), in_rows.get(), on_first.get(), INSERT_VALUES, SCATTER_FORWARD), what);
  PetscInt count = 0;
  check(VecGetLocalSize(on_first.get(), &count), what);
  const double* values = nullptr;
  check(VecGetArrayRead(on_first.get(), &values), what);
  std::vector<double> all(values, values + count);
  check(VecRestoreArrayRead(on_first.get(), &values), what);
  return all;
}

Matrix ElasticOperator::make_matrix() const {
  Matrix matrix;
  check(DMSetMatType(grid_.get(), MATAIJ), "making the stiffness matrix");
  check(DMCreateMatrix(grid_.get(), matrix.put()), "making the stiffness matrix");
  check(MatSetOption(matrix.get(), MAT_SPD, PETSC_TRUE), "making the stiffness matrix");
  return matrix;
}

void ElasticOperator::assemble(std::span<const Moduli> moduli, Mat matrix) const {
  constexpr const char* what = "assembling the stiffness matrix";
  double stiffest = 0.0;
  for (const auto& [bulk, shear] : moduli) stiffest = std::max(stiffest, bulk + shear);
  const auto by_kind = stiffnesses(moduli);
  check(MatZeroEntries(matrix), what);
  for (int row = cells_.first_row; row < cells_.last_row; ++row) {
    for (int column = cells_.first_column; column < cells_.last_column; ++column) {
      const CellVector free = held_mask(column, row);
      CellMatrix stiffness = free.asDiagonal() * by_kind[kind_of_cell(column, row)] * free.asDiagonal();
      stiffness.diagonal() += stiffest * (CellVector::Ones() - free);
      const auto nodes = nodes_of_cell(column, row);
      // PETSc reads row by row what Eigen stores column by column; the matrix is symmetric.
      check(MatSetValuesBlockedLocal(matrix, 4, nodes.data(), 4, nodes.data(), stiffness.data(), ADD_VALUES), what);
    }
  }
  check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY), what);
  check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY), what);
}

void ElasticOperator::attach_rigid_motions(Mat matrix) const {
  constexpr const char* what = "setting up the rigid motions";
  check(DMDASetUniformCoordinates(grid_.get(), 0.0, columns_, 0.0, rows_, 0.0, 0.0), what);
  Vec coordinates = nullptr;
  check(DMGetCoordinates(grid_.get(), &coordinates), what);
  PetscHandle<MatNullSpace, MatNullSpaceDestroy> rigid_motions;
  check(MatNullSpaceCreateRigidBody(coordinates, rigid_motions.put()), what);
  check(MatSetNearNullSpace(matrix, rigid_motions.get()), what);
}

}  // namespace breccia::quasistatic
