#include "total_lagrangian.hpp"

#include <utility>

#include "boundary_nodes.hpp"
#include "nodal_masses.hpp"

namespace breccia::dynamics {

TotalLagrangian::TotalLagrangian(DynamicProblem<2> given, int threads, InstructionSet instructions)
    : DynamicSolver<2>(std::move(given)),
      exchange_(problem().discretisation.grid(), problem().boundary == Boundary::periodic),
      rows_(problem(), instructions, exchange_.first(), exchange_.end()),
      masses_(nodal_masses(problem())),
      schedule_(rows_, exchange_, threads) {
  const auto& grid = problem().discretisation.grid();
  const double squared_step = problem().time_step * problem().time_step;
  grid.for_each_node([&](const Index<2>& node) {
    const auto [column, row] = node;
    const double mass = masses_[grid.node_index(node)];
    rows_.nodes().step_over_mass(row)[column] =
        is_prescribed(problem(), node) || mass == 0.0 ? 0.0 : squared_step / mass;
  });
}

void TotalLagrangian::set_velocities(const VelocityField& velocity) {
  const auto& grid = problem().discretisation.grid();
  const bool wraps = problem().boundary == Boundary::periodic;
  grid.for_each_node([&](const Index<2>& node) {
    if (is_prescribed(problem(), node)) return;
    const auto [column, row] = node;
    const int x = wraps && column == grid.columns() ? 0 : column, y = wraps && row == grid.rows() ? 0 : row;
    const auto v = velocity({x * grid.cell_side, y * grid.cell_side});
    const auto increment = rows_.nodes().increment(row);
    increment.x[column] = problem().time_step * v[0];
    increment.y[column] = problem().time_step * v[1];
  });
}

void TotalLagrangian::take_steps(std::int64_t first, int steps, Averages<2>* averages) {
  schedule_.take_steps(first, steps, averages);
}

}  // namespace breccia::dynamics
