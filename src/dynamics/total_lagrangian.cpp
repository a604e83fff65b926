#include "total_lagrangian.hpp"

#include <cstddef>
#include <utility>

#include "boundary_nodes.hpp"
#include "nodal_mass.hpp"

namespace breccia::dynamics {

template <int dim>
TotalLagrangian<dim>::TotalLagrangian(DynamicProblem<dim> given, int threads, InstructionSet instructions)
    : DynamicSolver<dim>(std::move(given)),
      exchange_(problem().discretisation.grid(), problem().boundary == Boundary::periodic),
      layers_(problem(), instructions, exchange_.first(), exchange_.end()),
      schedule_(layers_, exchange_, threads) {
  const auto& grid = problem().discretisation.grid();
  const double squared_step = problem().time_step * problem().time_step;
  // The forces of the kernel are divided by h^(dim - 2).
  const double numerator = times_power<dim - 2>(squared_step, grid.cell_side);
  auto& nodes = layers_.nodes();
  const auto set_step_over_mass = [&](const Index<dim>& node) {
    const double mass = nodal_mass(problem(), node);
    nodes.step_over_mass(nodes.row_of(node))[node[0]] =
        is_prescribed(problem(), node) || mass == 0.0 ? 0.0 : numerator / mass;
  };
  nodes.for_each_layer([&](int layer) { for_nodes_of_layer(grid, layer, set_step_over_mass); });
}

template <int dim>
void TotalLagrangian<dim>::set_velocities(const VelocityField& velocity) {
  const auto& grid = problem().discretisation.grid();
  const bool wraps = problem().boundary == Boundary::periodic;
  auto& nodes = layers_.nodes();
  const auto set_increment = [&](const Index<dim>& node) {
    if (is_prescribed(problem(), node)) return;
    Vector<dim> position{};
    for (std::size_t axis = 0; axis < position.size(); ++axis) {
      const bool is_last = wraps && node[axis] == grid.cells[axis];
      position[axis] = (is_last ? 0 : node[axis]) * grid.cell_side;
    }
    const auto v = velocity(position);
    const auto increment = nodes.increment(nodes.row_of(node));
    for (std::size_t i = 0; i < v.size(); ++i) increment[i][node[0]] = problem().time_step * v[i];
  };
  nodes.for_each_layer([&](int layer) { for_nodes_of_layer(grid, layer, set_increment); });
}

template <int dim>
void TotalLagrangian<dim>::take_steps(std::int64_t first, int steps, Averages<dim>* averages) {
  schedule_.take_steps(first, steps, averages);
}

template class TotalLagrangian<2>;
template class TotalLagrangian<3>;

}  // namespace breccia::dynamics
