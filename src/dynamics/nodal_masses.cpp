#include "nodal_masses.hpp"

#include <cstddef>

#include "breccia/discretisation/cell_shape.hpp"

namespace breccia::dynamics {

namespace {

/// Gives opposite nodes the sum of their masses, one axis after the other.
template <int dim>
void join_images(const Grid<dim>& grid, std::vector<double>& masses) {
  for (std::size_t axis = 0; axis < grid.cells.size(); ++axis) {
    auto end = grid.nodes();
    end[axis] = 1;
    for_each_index(Index<dim>{}, end, [&](const Index<dim>& node) {
      auto image = node;
      image[axis] = grid.cells[axis];
      double& mass = masses[grid.node_index(image)];
      masses[grid.node_index(node)] = mass += masses[grid.node_index(node)];
    });
  }
}

}  // namespace

template <int dim>
std::vector<double> nodal_masses(const DynamicProblem<dim>& problem) {
  using Shape = CellShape<dim>;
  const auto& grid = problem.discretisation.grid();
  const double point_volume = times_power<dim>(Shape::point_volume, grid.cell_side);
  std::vector<double> masses(grid.node_count(), 0.0);
  grid.for_each_cell([&](const Index<dim>& cell) {
    for (int p = 0; p < Shape::points; ++p) {
      const auto phase = problem.discretisation.cell(cell)[static_cast<std::size_t>(p)];
      if (phase == no_phase) continue;
      const double mass = problem.density_factor * problem.materials[phase].density * point_volume;
      const auto weights = Shape::weights(p);
      for (int n = 0; n < Shape::nodes; ++n) {
        auto node = Shape::corner(n);
        for (std::size_t axis = 0; axis < node.size(); ++axis) node[axis] += cell[axis];
        masses[grid.node_index(node)] += weights[static_cast<std::size_t>(n)] * mass;
      }
    }
  });
  if (problem.boundary == Boundary::periodic) join_images(grid, masses);
  return masses;
}

template std::vector<double> nodal_masses(const DynamicProblem<2>&);
template std::vector<double> nodal_masses(const DynamicProblem<3>&);

}  // namespace breccia::dynamics
