#include "quasistatic/solvers/lattice/wall_preconditioner.hpp"

#include <algorithm>
#include <numbers>

#include <omp.h>

namespace breccia::quasistatic {

WallPreconditioner::WallPreconditioner(const NodeLattice& lattice, int threads)
    : lattice_(lattice), exchange_(lattice), threads_(threads), is_fixed_(lattice.boundary == Boundary::displacement) {
  for (std::size_t axis = 0; axis < angles_.size(); ++axis) {
    angles_[axis] = half_angles(lattice_.nodes[axis], std::numbers::pi / lattice_.cells[axis]);
  }
  const auto kind = is_fixed_ ? WallTransform::Kind::sine : WallTransform::Kind::cosine;
  for (std::size_t axis = 0; axis < angles_.size(); ++axis) {
    const auto& transform = transforms_.emplace_back(kind, lattice_.cells[axis], rows_along(axis, nullptr).pairs);
    for (int thread = 0; thread < threads; ++thread) waves_[axis].push_back(transform.make_waves());
  }
}

PairedRows WallPreconditioner::rows_along(std::size_t axis, double* first) const {
  const auto& [nodes, row, plane] = lattice_.arrays;
  if (axis > 0) {
    // The pairs of rows are neighbours along the first axis, including the entries behind the last node.
    return {.first = first,
            .apart = axis == 1 ? row : exchange_.plane(),
            .partner = 1,
            .pairs = row / 2,
            .distance = 2,
            .is_last_alone = false};
  }
  return {.first = first,
          .apart = 1,
          .partner = row,
          .pairs = (static_cast<std::size_t>(nodes[1]) + 1) / 2,
          .distance = 2 * row,
          .is_last_alone = nodes[1] % 2 == 1};
}

void WallPreconditioner::transform(std::size_t axis, double* first, std::complex<double>* waves) const {
  if (!is_fixed_) double_ends(axis, first);
  transforms_[axis].apply(rows_along(axis, first), waves);
}

void WallPreconditioner::apply(const Moduli& reference, const NodalField& forces, NodalField& displacement) {
  transform_planes(forces, displacement);
  exchange_.give_planes_for_rows(displacement);
  divide_by_laplacian(reference, displacement);
  exchange_.give_rows_for_planes(displacement);
  transform_planes_back(displacement);
}

/// Doubles the forces on both ends of rows of nodes, which stand for half a period of an even function.
void WallPreconditioner::double_ends(std::size_t axis, double* values) const {
  const auto& [nodes, row, plane] = lattice_.arrays;
  const std::size_t rows = axis == 0 ? static_cast<std::size_t>(nodes[1]) : row;
  const std::size_t apart = axis == 0 ? 1 : axis == 1 ? row : exchange_.plane(), rows_apart = axis == 0 ? row : 1;
  const auto last = static_cast<std::size_t>(lattice_.cells[axis]) * apart;
  for (std::size_t line = 0; line < rows; ++line) {
    values[line * rows_apart] *= 2.0;
    values[line * rows_apart + last] *= 2.0;
  }
}

void WallPreconditioner::transform_planes(const NodalField& forces, NodalField& waves) const {
  for_planes(lattice_, threads_, [&](std::size_t first) {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    double* values = waves.all().data() + first;
    std::copy_n(forces.all().data() + first, lattice_.arrays.plane, values);
    for (const std::size_t axis : {0U, 1U}) transform(axis, values, waves_[axis][thread].get());
  });
}

void WallPreconditioner::divide_by_laplacian(const Moduli& reference, NodalField& waves) {
#pragma omp parallel for num_threads(threads_)
  for (int row = 0; row < exchange_.rows(); ++row) {
    auto* memory = waves_[2][static_cast<std::size_t>(omp_get_thread_num())].get();
    const auto second = static_cast<std::size_t>(exchange_.first_row()) + static_cast<std::size_t>(row);
    for (std::size_t component = 0; component < 3; ++component) {
      double* values = exchange_.row(waves, component, row);
      transform(2, values, memory);
      divide_row(reference, second, values);
      transforms_[2].apply(rows_along(2, values), memory);
    }
  }
}

/// Divides the waves of one component and one row along the second axis by the Laplacian. A fixed box has no values at
/// the walls.
void WallPreconditioner::divide_row(const Moduli& reference, std::size_t second, double* values) const {
  const auto& cells = lattice_.cells;
  const double scale = 1.0 / (reference.shear * 8.0 * cells[0] * cells[1] * cells[2]);
  for (std::size_t third = 0; third < angles_[2].size(); ++third) {
    double* of_row = values + third * exchange_.plane();
    for (std::size_t first = 0; first < angles_[0].size(); ++first) {
      const bool is_rest = first == 0 && second == 0 && third == 0;
      const WaveSymbol symbol(angles_[0][first], angles_[1][second], angles_[2][third]);
      of_row[first] = is_rest ? 0.0 : of_row[first] * (scale / symbol.laplacian());
    }
  }
}

void WallPreconditioner::transform_planes_back(NodalField& waves) const {
  for_planes(lattice_, threads_, [&](std::size_t first) {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    double* values = waves.all().data() + first;
    for (const std::size_t axis : {1U, 0U}) {
      transforms_[axis].apply(rows_along(axis, values), waves_[axis][thread].get());
    }
  });
}

}  // namespace breccia::quasistatic
