// The state of a run: memory, momentum, energy, fields and checkpoints. The steps are in row_step.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "breccia/checkpoint/state.hpp"
#include "breccia/discretisation/cell_shape.hpp"

#include "boundary_nodes.hpp"
#include "total_lagrangian.hpp"

namespace breccia::dynamics {
namespace {

using Shape = CellShape<2>;

/// Values at the nodes of a cell, from those along the rows of nodes below and above.
Shape::Values cell_values(const NodeRows::Components<const double>& below,
                          const NodeRows::Components<const double>& above, int column) {
  const double *x0 = below.x + column, *y0 = below.y + column, *x1 = above.x + column, *y1 = above.y + column;
  Shape::Values values;
  values << x0[0], y0[0], x0[1], y0[1], x1[0], y1[0], x1[1], y1[1];
  return values;
}

Shape::PointModuli elastic_moduli(const DynamicProblem<2>& problem, const Index<2>& cell) {
  Shape::PointModuli moduli{};
  const auto& phases = problem.discretisation.cell(cell);
  for (std::size_t p = 0; p < moduli.size(); ++p) {
    if (phases[p] == no_phase) continue;
    const auto& material = problem.materials[phases[p]];
    moduli[p] = {material.bulk.equilibrium(), material.shear.equilibrium()};
  }
  return moduli;
}

/// Stress xx, yy, zz, xy [Pa] of a point under a strain with engineering shear: the springs, then the Maxwell terms,
/// whose modes combine as those of the strain do.
std::array<double, 4> stress_of(const DynamicProblem<2>& problem, PhaseIndex phase, int point,
                                const Shape::StrainVector& strain, const BlockLayout::Histories& history) {
  const auto& [name, density, bulk, shear] = problem.materials[phase];
  const double h = problem.discretisation.grid().cell_side;
  const auto [x, y] = Shape::offset(point);
  const auto& [sxx, syy, sxy, squ, sqv] = history.shear;
  const auto& [centre, bqu, bqv] = history.bulk;
  const bool averaged = problem.volumetric == Volumetric::averaged;
  const double along_x = averaged ? 0.5 * (y * squ - x * sqv) : y * squ;
  const double along_y = averaged ? -along_x : x * sqv;
  const double volumetric = strain[0] + strain[1];
  const double pressure = bulk.equilibrium() * volumetric + (centre + y * bqu + x * bqv) / h;
  const double gxx = shear.equilibrium() * strain[0] + (sxx + along_x) / h;
  const double gyy = shear.equilibrium() * strain[1] + (syy + along_y) / h;
  const double gxy = shear.equilibrium() * strain[2] + (sxy + x * squ + y * sqv) / h;
  return {pressure + 4.0 / 3.0 * gxx - 2.0 / 3.0 * gyy, pressure + 4.0 / 3.0 * gyy - 2.0 / 3.0 * gxx,
          pressure - 2.0 / 3.0 * (gxx + gyy), gxy};
}

}  // namespace

Footprint TotalLagrangian::footprint() const {
  constexpr std::size_t fields_moved = 9;  // five read, of which four are written
  const auto rows = static_cast<std::size_t>(exchange_.end() - exchange_.first());
  const auto& nodes = rows_.nodes();
  const auto& layout = rows_.layout();
  return {
      .held = problem().discretisation.cells().size() * sizeof(CellPhases<2>) + layout.material_bytes() +
              layout.history_bytes() + (nodes.values().size() + masses_.size()) * sizeof(double) + schedule_.bytes(),
      .moved_per_step =
          rows * nodes.stride() * fields_moved * sizeof(double) + layout.material_bytes() + 2 * layout.history_bytes()};
}

void TotalLagrangian::fetch_nodes() const {
  exchange_.gather_node_rows(rows_.nodes().values());
}

Vector<2> TotalLagrangian::momentum() const {
  fetch_nodes();
  const auto& grid = problem().discretisation.grid();
  Vector<2> sum = {0.0, 0.0};
  grid.for_each_node([&](const Index<2>& node) {
    if (is_image(problem(), node)) return;
    const auto [column, row] = node;
    const auto increment = rows_.nodes().increment(row);
    const double mass = masses_[grid.node_index(node)];
    sum[0] += mass * increment.x[column] / problem().time_step;
    sum[1] += mass * increment.y[column] / problem().time_step;
  });
  return sum;
}

Energy TotalLagrangian::energy() const {
  require_elastic();
  fetch_nodes();
  const auto& grid = problem().discretisation.grid();
  const auto& nodes = std::as_const(rows_).nodes();
  Energy energy;
  grid.for_each_node([&](const Index<2>& node) {
    if (is_image(problem(), node)) return;
    const auto [column, row] = node;
    const auto increment = nodes.increment(row);
    const double vx = increment.x[column] / problem().time_step, vy = increment.y[column] / problem().time_step;
    energy.kinetic += 0.5 * masses_[grid.node_index(node)] * (vx * vx + vy * vy);
  });
  grid.for_each_cell([&](const Index<2>& cell) {
    const auto [column, row] = cell;
    const Shape::Values u = cell_values(nodes.displacement(row), nodes.displacement(row + 1), column);
    const Shape::Values du = cell_values(nodes.increment(row), nodes.increment(row + 1), column);
    const auto stiffness = Shape::stiffness(elastic_moduli(problem(), cell), problem().volumetric);
    energy.strain += 0.5 * u.dot(stiffness * (u - du));
  });
  return energy;
}

void TotalLagrangian::set_fields_of_cell(PointFields<2>& fields, const Index<2>& cell) const {
  const auto& discretisation = problem().discretisation;
  const auto& grid = discretisation.grid();
  const auto& nodes = std::as_const(rows_).nodes();
  const auto [column, row] = cell;
  const Shape::Values u = cell_values(nodes.displacement(row), nodes.displacement(row + 1), column);
  for (int p = 0; p < Shape::points; ++p) {
    const auto phase = discretisation.cell(cell)[static_cast<std::size_t>(p)];
    const auto point = grid.point_index(cell, p);
    if (phase == no_phase) continue;
    const auto weights = Shape::weights(p);
    for (std::size_t node = 0; node < weights.size(); ++node) {
      fields.displacement[point][0] += weights[node] * u[static_cast<Eigen::Index>(2 * node)];
      fields.displacement[point][1] += weights[node] * u[static_cast<Eigen::Index>(2 * node + 1)];
    }
    const Shape::StrainVector strain = Shape::strain_matrix(p, problem().volumetric) * u / grid.cell_side;
    fields.strain[point] = {strain[0], strain[1], 0.5 * strain[2]};
    fields.stress[point] = stress_of(problem(), phase, p, strain, rows_.layout().histories(column, row, phase));
  }
}

PointFields<2> TotalLagrangian::fields() const {
  const auto& grid = problem().discretisation.grid();
  auto fields = zero_fields(problem().discretisation);
  for_each_index(Index<2>{0, exchange_.first()}, Index<2>{grid.columns(), exchange_.end()},
                 [&](const Index<2>& cell) { set_fields_of_cell(fields, cell); });
  exchange_.gather_cell_rows({fields.displacement.front().data(), 2 * fields.displacement.size()});
  exchange_.gather_cell_rows({fields.strain.front().data(), 3 * fields.strain.size()});
  exchange_.gather_cell_rows({fields.stress.front().data(), 4 * fields.stress.size()});
  return fields;
}

Vector<2> TotalLagrangian::most_moved() const {
  fetch_nodes();
  const auto& grid = problem().discretisation.grid();
  Vector<2> place = {0.0, 0.0};
  double most = 0.0;
  for (int row = 0; row <= grid.rows(); ++row) {
    const auto increment = rows_.nodes().increment(row);
    for (int column = 0; column <= grid.columns(); ++column) {
      const double moved = std::hypot(increment.x[column], increment.y[column]);
      if (moved <= most) continue;
      most = moved;
      place = {column * grid.cell_side, row * grid.cell_side};
      if (!std::isfinite(moved)) return place;
    }
  }
  return place;
}

void TotalLagrangian::save_arrays(StateWriter& state, const std::string& group) const {
  fetch_nodes();
  state.write(group + "/nodes", std::as_const(rows_).nodes().values());
  std::vector<double> all;
  state.write(group + "/history", exchange_.collect(std::as_const(rows_).layout().history(), all));
}

void TotalLagrangian::restore_arrays(const StateReader& state, const std::string& group) {
  const auto nodes = rows_.nodes().values();
  std::ranges::copy(state.numbers(group + "/nodes", nodes.size()), nodes.begin());
  const auto own = rows_.layout().history();
  const auto [begin, size] = exchange_.place_of(own.size());
  const auto all = state.numbers(group + "/history", size);
  std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(begin), own.size(), own.begin());
}

}  // namespace breccia::dynamics
