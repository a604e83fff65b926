#include "solvers/wall_preconditioner.hpp"

#include <algorithm>
#include <numbers>

#include <omp.h>

namespace breccia::quasistatic {

WallPreconditioner::WallPreconditioner(const NodeLattice& lattice, int threads)
    : lattice_(lattice), threads_(threads), is_fixed_(lattice.boundary == Boundary::displacement) {
  const auto& [nodes, row, plane] = lattice_.arrays;
  for (std::size_t axis = 0; axis < angles_.size(); ++axis) {
    angles_[axis] = half_angles(nodes[axis], std::numbers::pi / lattice_.cells[axis]);
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
    // Neighbours along the first axis, with the places behind the last node.
    return {.first = first,
            .apart = axis == 1 ? row : plane,
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

void WallPreconditioner::transform(std::size_t axis, double* first, fftw_complex* waves) const {
  if (!is_fixed_) double_ends(axis, first);
  transforms_[axis].apply(rows_along(axis, first), waves);
}

void WallPreconditioner::apply(const Moduli& reference, const LatticeField& forces, LatticeField& displacement) {
  transform_planes(forces, displacement);
  divide_by_laplacian(reference, displacement);
  transform_planes_back(displacement);
}

/// Doubles the forces on both ends of rows of nodes, which stand for half a period of an even function.
void WallPreconditioner::double_ends(std::size_t axis, double* values) const {
  const auto& [nodes, row, plane] = lattice_.arrays;
  const std::size_t rows = axis == 0 ? static_cast<std::size_t>(nodes[1]) : row;
  const std::size_t apart = axis == 0 ? 1 : axis == 1 ? row : plane, rows_apart = axis == 0 ? row : 1;
  const auto last = static_cast<std::size_t>(lattice_.cells[axis]) * apart;
  for (std::size_t line = 0; line < rows; ++line) {
    values[line * rows_apart] *= 2.0;
    values[line * rows_apart + last] *= 2.0;
  }
}

void WallPreconditioner::transform_planes(const LatticeField& forces, LatticeField& waves) const {
  const auto plane = lattice_.arrays.plane;
#pragma omp parallel for num_threads(threads_)
  for (int k = 0; k < 3 * lattice_.arrays.nodes[2]; ++k) {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    const auto first = static_cast<std::size_t>(k) * plane;
    double* values = waves.all().data() + first;
    std::copy_n(forces.all().data() + first, plane, values);
    for (const std::size_t axis : {0U, 1U}) transform(axis, values, waves_[axis][thread].get());
  }
}

void WallPreconditioner::divide_by_laplacian(const Moduli& reference, LatticeField& waves) const {
  const auto& [nodes, row, plane] = lattice_.arrays;
#pragma omp parallel for num_threads(threads_)
  for (int second = 0; second < nodes[1]; ++second) {
    auto* memory = waves_[2][static_cast<std::size_t>(omp_get_thread_num())].get();
    for (std::size_t component = 0; component < 3; ++component) {
      double* values = waves.component(component) + static_cast<std::size_t>(second) * row;
      transform(2, values, memory);
      divide_row(reference, static_cast<std::size_t>(second), values);
      transforms_[2].apply(rows_along(2, values), memory);
    }
  }
}

/// Divides the waves of one component and one row along the second axis by the Laplacian. A fixed box has none at the
/// walls.
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
  const auto plane = lattice_.arrays.plane;
#pragma omp parallel for num_threads(threads_)
  for (int k = 0; k < 3 * lattice_.arrays.nodes[2]; ++k) {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    double* values = waves.all().data() + static_cast<std::size_t>(k) * plane;
    for (const std::size_t axis : {1U, 0U})
      transforms_[axis].apply(rows_along(axis, values), waves_[axis][thread].get());
  }
}

}  // namespace breccia::quasistatic
