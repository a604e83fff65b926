#include "row_step.hpp"

#include "boundary_nodes.hpp"
#include "kernels.hpp"
#include "step_times.hpp"

namespace breccia::dynamics {
namespace {

/// Gives the nodes at both ends of a row the forces of the cells at the other end.
void join_ends(const RowForces& forces, int columns) {
  forces.right_x[0] = forces.right_x[columns];
  forces.right_y[0] = forces.right_y[columns];
  forces.left_x[columns] = forces.left_x[0];
  forces.left_y[columns] = forces.left_y[0];
}

}  // namespace

RowStep::RowStep(const DynamicProblem<2>& problem, InstructionSet instructions, int first_row, int end_row)
    : problem_(&problem),
      kernels_(&kernels(instructions)),
      layout_(problem, first_row, end_row),
      nodes_(problem.discretisation.grid()) {}

void RowStep::find_forces(int row, const RowForces& below, const RowForces& above, RowSums& sums, int place) {
  const auto& grid = problem_->discretisation.grid();
  const auto u_below = nodes_.displacement(row), u_above = nodes_.displacement(row + 1);
  const auto du_below = nodes_.increment(row), du_above = nodes_.increment(row + 1);
  const CellRow cells = {.blocks = layout_.row(row),
                         .block_count = layout_.blocks_per_row(),
                         .displacement_below = {u_below.x, u_below.y},
                         .displacement_above = {u_above.x, u_above.y},
                         .increment_below = {du_below.x, du_below.y},
                         .increment_above = {du_above.x, du_above.y},
                         .below = below,
                         .above = above,
                         .stress = sums.of(row, place).stress.data()};
  if (problem_->volumetric == Volumetric::averaged) {
    kernels_->cell_row_averaged(cells);
  } else {
    kernels_->cell_row_standard(cells);
  }
  switch (problem_->boundary) {
    case Boundary::displacement:
      break;
    case Boundary::traction:
      sums.of(row, place).strain = boundary_strain(row);
      if (row + 1 == grid.rows()) sums.of(row + 1, place).strain = boundary_strain(row + 1);
      break;
    case Boundary::periodic:
      join_ends(below, grid.columns());
      join_ends(above, grid.columns());
      break;
  }
}

void RowStep::move_nodes(int row, const RowForces& from_cells_below, const RowForces& from_cells_above,
                         std::int64_t step) {
  const auto u = nodes_.displacement(row), du = nodes_.increment(row);
  kernels_->node_row({.count = (layout_.blocks_per_row() + 1) * lanes,
                      .displacement_x = u.x,
                      .displacement_y = u.y,
                      .increment_x = du.x,
                      .increment_y = du.y,
                      .step_over_mass = nodes_.step_over_mass(row),
                      .from_cells_below = from_cells_below,
                      .from_cells_above = from_cells_above});
  const bool load_rises = load_at(*problem_, step - 1) < 1.0;
  switch (problem_->boundary) {
    case Boundary::displacement:
      if (load_rises) follow_load(row, step);
      break;
    case Boundary::traction:
      add_traction(row, step);
      break;
    case Boundary::periodic:
      if (load_rises) follow_load(row, step);
      close_row(row, step);
      break;
  }
}

void RowStep::follow_load(int row, std::int64_t step) {
  const auto& grid = problem_->discretisation.grid();
  const double now = load_at(*problem_, step);
  const double next = load_at(*problem_, step + 1);
  const auto u = nodes_.displacement(row), du = nodes_.increment(row);
  if (follows_affinely(*problem_)) {
    const double acceleration = next - 2.0 * now + load_at(*problem_, step - 1);
    for (int column = 0; column <= grid.columns(); ++column) {
      const auto affine = affine_motion(*problem_, {column, row});
      u.x[column] += acceleration * affine[0];
      u.y[column] += acceleration * affine[1];
      du.x[column] += acceleration * affine[0];
      du.y[column] += acceleration * affine[1];
    }
  }
  if (problem_->boundary != Boundary::displacement) return;
  for_boundary_nodes(grid, row, [&](int column) {
    const auto affine = affine_motion(*problem_, {column, row});
    u.x[column] = next * affine[0];
    u.y[column] = next * affine[1];
    du.x[column] = (next - now) * affine[0];
    du.y[column] = (next - now) * affine[1];
  });
}

void RowStep::add_traction(int row, std::int64_t step) {
  const double now = load_at(*problem_, step);
  const auto u = nodes_.displacement(row), du = nodes_.increment(row);
  for_boundary_nodes(problem_->discretisation.grid(), row, [&](int column) {
    const auto force = traction_force(*problem_, {column, row});
    const double scale = now * nodes_.step_over_mass(row)[column];
    u.x[column] += scale * force[0];
    u.y[column] += scale * force[1];
    du.x[column] += scale * force[0];
    du.y[column] += scale * force[1];
  });
}

/// Makes the last node of a row the image of the first.
void RowStep::close_row(int row, std::int64_t step) {
  const int last = problem_->discretisation.grid().columns();
  const auto across = affine_difference(*problem_, {static_cast<double>(last), 0.0});
  const double next = load_at(*problem_, step + 1), rise = next - load_at(*problem_, step);
  const auto u = nodes_.displacement(row), du = nodes_.increment(row);
  u.x[last] = u.x[0] + next * across[0];
  u.y[last] = u.y[0] + next * across[1];
  du.x[last] = du.x[0] + rise * across[0];
  du.y[last] = du.y[0] + rise * across[1];
}

void RowStep::copy_lowest_row(std::int64_t step) {
  const auto& grid = problem_->discretisation.grid();
  const auto up = affine_difference(*problem_, {0.0, static_cast<double>(grid.rows())});
  const double next = load_at(*problem_, step + 1), rise = next - load_at(*problem_, step);
  const auto from_u = nodes_.displacement(0), from_du = nodes_.increment(0);
  const auto u = nodes_.displacement(grid.rows()), du = nodes_.increment(grid.rows());
  for (int column = 0; column <= grid.columns(); ++column) {
    u.x[column] = from_u.x[column] + next * up[0];
    u.y[column] = from_u.y[column] + next * up[1];
    du.x[column] = from_du.x[column] + rise * up[0];
    du.y[column] = from_du.y[column] + rise * up[1];
  }
}

Strain<2> RowStep::boundary_strain(int row) const {
  const auto& grid = problem_->discretisation.grid();
  const auto u = nodes_.displacement(row);
  Strain<2> sum;
  for_boundary_nodes(grid, row, [&](int column) {
    const auto area = outward_area<2>(grid, {column, row});
    sum.xx += u.x[column] * area[0];
    sum.yy += u.y[column] * area[1];
    sum.xy += 0.5 * (u.x[column] * area[1] + u.y[column] * area[0]);
  });
  return sum;
}

}  // namespace breccia::dynamics
