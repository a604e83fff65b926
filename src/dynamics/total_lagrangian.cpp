#include "dynamics/total_lagrangian.hpp"

#include <cstddef>
#include <utility>

#include "dynamics/boundary_nodes.hpp"
#include "dynamics/nodal_mass.hpp"
#include "dynamics/recovered_fields.hpp"

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

template <int dim>
OwnNodes<dim> TotalLagrangian<dim>::own_nodes() const noexcept {
  return {&problem(), &layers_.nodes(), exchange_.first(), exchange_.end_of_nodes()};
}

template <int dim>
Vector<dim> TotalLagrangian<dim>::momentum() const {
  return momentum_of(own_nodes());
}

template <int dim>
Energy TotalLagrangian<dim>::energy() const {
  require_elastic();
  return energy_of(own_nodes());
}

template <int dim>
Vector<dim> TotalLagrangian<dim>::most_moved() const {
  return most_moved_of(own_nodes());
}

template <int dim>
LatticeFields<dim> TotalLagrangian<dim>::fields() const {
  return recover_fields(problem(), layers_.nodes(), layers_.layout());
}

template <int dim>
Footprint TotalLagrangian<dim>::footprint() const {
  constexpr std::size_t fields_moved = 4 * dim + 1;  // 2 dim + 1 numbers are read, and 2 dim of them are written
  const auto layers = static_cast<std::size_t>(exchange_.end() - exchange_.first());
  const auto& nodes = layers_.nodes();
  const auto& layout = layers_.layout();
  return {.held = problem().discretisation.cells().size() * sizeof(CellPhases<dim>) + layout.material_bytes() +
                  layout.history_bytes() + nodes.bytes() + schedule_.bytes(),
          .moved_per_step = layers * nodes.layer_size() * fields_moved * sizeof(double) + layout.material_bytes() +
                            2 * layout.history_bytes()};
}

template class TotalLagrangian<2>;
template class TotalLagrangian<3>;

}  // namespace breccia::dynamics
