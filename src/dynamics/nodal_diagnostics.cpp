#include "dynamics/nodal_diagnostics.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "breccia/parallel/ordered_values.hpp"

#include "discretisation/cell_shape.hpp"
#include "dynamics/boundary_nodes.hpp"
#include "dynamics/layer_exchange.hpp"
#include "dynamics/nodal_mass.hpp"
#include "parallel/reduction.hpp"

namespace breccia::dynamics {
namespace {

/// Calls action(node) for the nodes of this process.
template <int dim, class Action>
void for_each_node(const OwnNodes<dim>& nodes, Action&& action) {
  for (int layer = nodes.first_layer; layer < nodes.end_layer; ++layer) {
    for_nodes_of_layer(nodes.problem->discretisation.grid(), layer, action);
  }
}

template <int dim>
typename CellShape<dim>::PointModuli elastic_moduli(const DynamicProblem<dim>& problem, const Index<dim>& cell) {
  typename CellShape<dim>::PointModuli moduli{};
  const auto& phases = problem.discretisation.cell(cell);
  for (std::size_t p = 0; p < moduli.size(); ++p) {
    if (phases[p] == no_phase) continue;
    const auto& material = problem.materials[phases[p]];
    moduli[p] = {material.bulk.equilibrium(), material.shear.equilibrium()};
  }
  return moduli;
}

}  // namespace

template <int dim>
Vector<dim> momentum_of(const OwnNodes<dim>& nodes) {
  const auto& problem = *nodes.problem;
  const auto& field = *nodes.field;
  Vector<dim> momentum{};
  parallel::sum_in_order(momentum, [&](std::span<double> sums) {
    for_each_node(nodes, [&](const Index<dim>& node) {
      if (is_image(problem, node)) return;
      const auto increment = field.increment(field.row_of(node));
      const double mass = nodal_mass(problem, node);
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += mass * increment[i][node[0]] / problem.time_step;
    });
  });
  return momentum;
}

template <int dim>
Energy energy_of(const OwnNodes<dim>& nodes) {
  const auto& problem = *nodes.problem;
  const auto& field = *nodes.field;
  const auto& grid = problem.discretisation.grid();
  const auto cells = own_layers(grid);
  std::array<double, 2> kinetic_and_strain{};
  parallel::sum_in_order(kinetic_and_strain, [&](std::span<double> sums) {
    for_each_node(nodes, [&](const Index<dim>& node) {
      if (is_image(problem, node)) return;
      double squared = 0.0;
      for (const double* increment : field.increment(field.row_of(node))) {
        const double velocity = increment[node[0]] / problem.time_step;
        squared += velocity * velocity;
      }
      sums[0] += 0.5 * nodal_mass(problem, node) * squared;
    });
    for_each_index(cells.begin, cells.end, [&](const Index<dim>& cell) {
      const typename CellShape<dim>::Values u = field.displacement_of_cell(cell);
      const typename CellShape<dim>::Values du = field.increment_of_cell(cell);
      const auto stiffness = CellShape<dim>::stiffness(elastic_moduli(problem, cell), problem.volumetric);
      sums[1] += times_power<dim - 2>(0.5 * u.dot(stiffness * (u - du)), grid.cell_side);
    });
  });
  return {.kinetic = kinetic_and_strain[0], .strain = kinetic_and_strain[1]};
}

template <int dim>
Vector<dim> most_moved_of(const OwnNodes<dim>& nodes) {
  const auto& problem = *nodes.problem;
  const auto& field = *nodes.field;
  Vector<dim> position{};
  double most = 0.0;
  for_each_node(nodes, [&](const Index<dim>& node) {
    double moved = 0.0;
    for (const double* increment : field.increment(field.row_of(node))) moved = std::hypot(moved, increment[node[0]]);
    // A value that is not finite counts as the largest.
    if (!std::isfinite(moved)) moved = std::numeric_limits<double>::infinity();
    if (moved <= most) return;
    most = moved;
    for (std::size_t axis = 0; axis < position.size(); ++axis) {
      position[axis] = node[axis] * problem.discretisation.grid().cell_side;
    }
  });
  const bool is_here = parallel::is_first_largest(most);
  for (double& along : position) along = parallel::sum(is_here ? along : 0.0);
  return position;
}

template Vector<2> momentum_of(const OwnNodes<2>&);
template Energy energy_of(const OwnNodes<2>&);
template Vector<2> most_moved_of(const OwnNodes<2>&);
template Vector<3> momentum_of(const OwnNodes<3>&);
template Energy energy_of(const OwnNodes<3>&);
template Vector<3> most_moved_of(const OwnNodes<3>&);

}  // namespace breccia::dynamics
