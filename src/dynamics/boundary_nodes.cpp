#include "boundary_nodes.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "nodal_masses.hpp"

namespace breccia::dynamics {

bool is_prescribed(const DynamicProblem& problem, int column, int row) noexcept {
  const auto& grid = problem.discretisation.grid();
  return problem.boundary == Boundary::displacement &&
         (column == 0 || row == 0 || column == grid.columns || row == grid.rows);
}

bool is_image(const DynamicProblem& problem, int column, int row) noexcept {
  const auto& grid = problem.discretisation.grid();
  return problem.boundary == Boundary::periodic && (column == grid.columns || row == grid.rows);
}

bool follows_affinely(const DynamicProblem& problem) noexcept {
  switch (problem.boundary) {
    case Boundary::displacement:
      return problem.start == Start::affine;
    case Boundary::traction:
      return false;
    case Boundary::periodic:
      return true;
  }
  return false;
}

Vector<2> affine_motion(const DynamicProblem& problem, int column, int row) noexcept {
  if (problem.boundary != Boundary::displacement) return affine_difference(problem, column, row);
  const auto& grid = problem.discretisation.grid();
  return affine_difference(problem, column - 0.5 * grid.columns, row - 0.5 * grid.rows);
}

Vector<2> affine_difference(const DynamicProblem& problem, double columns, double rows) noexcept {
  const double h = problem.discretisation.grid().cell_side;
  const auto& load = problem.load;
  const double x = columns * h, y = rows * h;
  return {load.xx * x + load.xy * y, load.xy * x + load.yy * y};
}

Vector<2> outward_side(const Grid& grid, int column, int row) noexcept {
  const auto normal = [](int place, int last) { return place == 0 ? -1.0 : place == last ? 1.0 : 0.0; };
  const auto length = [&](int place, int last) { return grid.cell_side * (place == 0 || place == last ? 0.5 : 1.0); };
  return {normal(column, grid.columns) * length(row, grid.rows), normal(row, grid.rows) * length(column, grid.columns)};
}

Vector<2> traction_force(const DynamicProblem& problem, int column, int row) noexcept {
  const auto side = outward_side(problem.discretisation.grid(), column, row);
  const auto& half = problem.load;
  return {2.0 * (half.xx * side[0] + half.xy * side[1]), 2.0 * (half.xy * side[0] + half.yy * side[1])};
}

void require_points_under_traction(const DynamicProblem& problem) {
  if (problem.boundary != Boundary::traction || problem.load == PlaneStrain{}) return;
  const auto& grid = problem.discretisation.grid();
  const auto masses = nodal_masses(problem);
  for (int row = 0; row <= grid.rows; ++row) {
    for_boundary_nodes(grid, row, [&](int column) {
      if (masses[grid.node_index(column, row)] > 0.0) return;
      throw InputError(fmt::format("dynamic run: a traction acts at ({:.4g}, {:.4g}) m, where the box has no points",
                                   column * grid.cell_side, row * grid.cell_side));
    });
  }
}

}  // namespace breccia::dynamics
