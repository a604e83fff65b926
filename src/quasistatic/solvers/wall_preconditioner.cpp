#include "solvers/wall_preconditioner.hpp"

#include <algorithm>
#include <numbers>

namespace breccia::quasistatic {

WallPreconditioner::WallPreconditioner(const NodeLattice& lattice, int threads)
    : lattice_(lattice), threads_(threads), is_fixed_(lattice.boundary == Boundary::displacement) {
  const auto& [nodes, row, plane] = lattice_.arrays;
  for (std::size_t axis = 0; axis < angles_.size(); ++axis) {
    angles_[axis] = half_angles(nodes[axis], std::numbers::pi / lattice_.cells[axis]);
  }
  LatticeField field(lattice_);
  double* values = field.component(0);
  const auto along = [&](std::size_t axis) { return static_cast<std::size_t>(nodes[axis]); };
  plans_[0] = plan(0, along(1), 1, row, values);
  plans_[1] = plan(1, along(0), row, 1, values);
  plans_[2] = plan(2, along(0), plane, 1, values);
}

/// Transforms of `rows` rows of nodes along an axis. Nodes of a row are `apart`, rows are `rows_apart`.
FourierPlan WallPreconditioner::plan(std::size_t axis, std::size_t rows, std::size_t apart, std::size_t rows_apart,
                                     double* values) const {
  // The sine transform takes the nodes between the walls.
  const int count = is_fixed_ ? lattice_.cells[axis] - 1 : lattice_.cells[axis] + 1;
  const auto kind = is_fixed_ ? FFTW_RODFT00 : FFTW_REDFT00;
  double* first = values + (is_fixed_ ? apart : 0);
  const int node_step = static_cast<int>(apart), row_step = static_cast<int>(rows_apart);
  return made_plan(fftw_plan_many_r2r(1, &count, static_cast<int>(rows), first, nullptr, node_step, row_step, first,
                                      nullptr, node_step, row_step, &kind, plan_flags));
}

void WallPreconditioner::apply(const Moduli& reference, const LatticeField& forces, LatticeField& displacement) {
  transform_planes(forces, displacement);
  divide_by_laplacian(reference, displacement);
  transform_planes_back(displacement);
}

/// Doubles the forces on both ends of rows of nodes, which stand for half a period of an even function.
void WallPreconditioner::double_ends(double* values, std::size_t axis, std::size_t rows, std::size_t apart,
                                     std::size_t rows_apart) const {
  const auto last = static_cast<std::size_t>(lattice_.cells[axis]) * apart;
  for (std::size_t row = 0; row < rows; ++row) {
    values[row * rows_apart] *= 2.0;
    values[row * rows_apart + last] *= 2.0;
  }
}

void WallPreconditioner::transform_planes(const LatticeField& forces, LatticeField& waves) const {
  const auto& [nodes, row, plane] = lattice_.arrays;
  const auto width = static_cast<std::size_t>(nodes[0]), rows = static_cast<std::size_t>(nodes[1]);
  const std::size_t skipped_in_row = is_fixed_ ? 1 : 0, skipped_rows = is_fixed_ ? row : 0;
#pragma omp parallel for num_threads(threads_)
  for (int k = 0; k < 3 * nodes[2]; ++k) {
    const auto first = static_cast<std::size_t>(k) * plane;
    double* values = waves.all().data() + first;
    std::copy_n(forces.all().data() + first, plane, values);
    if (!is_fixed_) double_ends(values, 0, rows, 1, row);
    fftw_execute_r2r(plans_[0].get(), values + skipped_in_row, values + skipped_in_row);
    if (!is_fixed_) double_ends(values, 1, width, row, 1);
    fftw_execute_r2r(plans_[1].get(), values + skipped_rows, values + skipped_rows);
  }
}

void WallPreconditioner::divide_by_laplacian(const Moduli& reference, LatticeField& waves) const {
  const auto& [nodes, row, plane] = lattice_.arrays;
  const auto width = static_cast<std::size_t>(nodes[0]);
  const std::size_t skipped_planes = is_fixed_ ? plane : 0;
#pragma omp parallel for num_threads(threads_)
  for (int second = 0; second < nodes[1]; ++second) {
    for (std::size_t component = 0; component < 3; ++component) {
      double* values = waves.component(component) + static_cast<std::size_t>(second) * row;
      if (!is_fixed_) double_ends(values, 2, width, plane, 1);
      fftw_execute_r2r(plans_[2].get(), values + skipped_planes, values + skipped_planes);
      divide_row(reference, static_cast<std::size_t>(second), values);
      fftw_execute_r2r(plans_[2].get(), values + skipped_planes, values + skipped_planes);
    }
  }
}

/// Divides the waves of one component and one row along the second axis by the Laplacian.
void WallPreconditioner::divide_row(const Moduli& reference, std::size_t second, double* values) const {
  const auto& cells = lattice_.cells;
  const double scale = 1.0 / (reference.shear * 8.0 * cells[0] * cells[1] * cells[2]);
  for (std::size_t third = 0; third < angles_[2].size(); ++third) {
    double* of_row = values + third * lattice_.arrays.plane;
    for (std::size_t first = 0; first < angles_[0].size(); ++first) {
      const bool is_rest = first == 0 && second == 0 && third == 0;
      const WaveSymbol symbol(angles_[0][first], angles_[1][second], angles_[2][third]);
      of_row[first] = is_rest ? 0.0 : of_row[first] * (scale / symbol.laplacian());
    }
  }
}

void WallPreconditioner::transform_planes_back(LatticeField& waves) const {
  const auto& [nodes, row, plane] = lattice_.arrays;
  const std::size_t skipped_in_row = is_fixed_ ? 1 : 0, skipped_rows = is_fixed_ ? row : 0;
#pragma omp parallel for num_threads(threads_)
  for (int k = 0; k < 3 * nodes[2]; ++k) {
    double* values = waves.all().data() + static_cast<std::size_t>(k) * plane;
    fftw_execute_r2r(plans_[1].get(), values + skipped_rows, values + skipped_rows);
    fftw_execute_r2r(plans_[0].get(), values + skipped_in_row, values + skipped_in_row);
  }
}

}  // namespace breccia::quasistatic
