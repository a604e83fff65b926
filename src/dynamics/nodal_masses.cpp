#include "nodal_masses.hpp"

#include <array>
#include <cstddef>

#include "breccia/discretisation/cell.hpp"

namespace breccia::dynamics {

namespace {

void join_images(const Grid& grid, std::vector<double>& masses) {
  const auto join = [&](std::size_t node, std::size_t image) { masses[node] = masses[image] += masses[node]; };
  for (int row = 0; row <= grid.rows; ++row) join(grid.node_index(0, row), grid.node_index(grid.columns, row));
  for (int column = 0; column <= grid.columns; ++column) {
    join(grid.node_index(column, 0), grid.node_index(column, grid.rows));
  }
}

}  // namespace

std::vector<double> nodal_masses(const DynamicProblem& problem) {
  const auto& grid = problem.discretisation.grid();
  const double point_area = 0.25 * grid.cell_side * grid.cell_side;
  std::vector<double> masses(grid.nodes(), 0.0);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const std::array<std::size_t, 4> nodes = {grid.node_index(column, row), grid.node_index(column + 1, row),
                                                grid.node_index(column, row + 1), grid.node_index(column + 1, row + 1)};
      for (int p = 0; p < points_per_cell; ++p) {
        const auto material = problem.discretisation.cell(column, row)[static_cast<std::size_t>(p)];
        if (material == no_material) continue;
        const double mass = problem.density_factor * problem.materials[material].density * point_area;
        const auto weights = node_weights(p);
        for (std::size_t node = 0; node < 4; ++node) masses[nodes[node]] += weights[node] * mass;
      }
    }
  }
  if (problem.boundary == Boundary::periodic) join_images(grid, masses);
  return masses;
}

}  // namespace breccia::dynamics
