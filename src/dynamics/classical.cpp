#include "classical.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "boundary_nodes.hpp"
#include "maxwell_step.hpp"

namespace breccia::dynamics {
namespace {

struct Shape {
  double weight;
  double dx;  ///< gradient times the cell side
  double dy;
};

/// Bilinear shape function of one node of a cell at a point of it (theory, Eq. 2).
Shape shape(std::size_t node, const Vector<2>& local) {
  const double sx = (node & 1U) != 0 ? 1.0 : -1.0;
  const double sy = (node & 2U) != 0 ? 1.0 : -1.0;
  const double wx = 0.5 + sx * local[0];
  const double wy = 0.5 + sy * local[1];
  return {wx * wy, sx * wy, wx * sy};
}

/// With fewer points than this a thread would mostly wait for the others.
int useful_threads(int threads, std::size_t points) {
  constexpr std::size_t points_per_thread = 4096;
  return std::clamp(static_cast<int>(points / points_per_thread), 1, threads);
}

}  // namespace

Classical::Classical(DynamicProblem given, int threads)
    : DynamicSolver(std::move(given)), threads_(useful_threads(threads, problem().discretisation.points())) {
  const double half_step = 0.5 * problem().time_step;
  for (const auto& material : problem().materials) {
    materials_.push_back({material.bulk.equilibrium(), material.shear.equilibrium(),
                          maxwell_steps(material.bulk, half_step), maxwell_steps(material.shear, half_step)});
  }
  const auto& discretisation = problem().discretisation;
  const auto& grid = discretisation.grid();
  const double point_area = 0.25 * grid.cell_side * grid.cell_side;
  std::size_t history = 0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      for (int p = 0; p < points_per_cell; ++p) {
        const auto material = discretisation.cell(column, row)[static_cast<std::size_t>(p)];
        if (material == no_material) continue;
        const auto position = discretisation.position(column, row, p);
        Point point{};
        point.position = position;
        point.mass = problem().density_factor * problem().materials[material].density * point_area;
        point.material = material;
        point.cell = row * grid.columns + column;
        point.history = history;
        point.lattice = grid.point_index(column, row, p);
        history += 3 * materials_[material].shear_terms.size() + materials_[material].bulk_terms.size();
        points_.push_back(point);
      }
    }
  }
  initial_area_ = point_area * static_cast<double>(points_.size());
  history_.assign(history, 0.0);
  nodes_.resize(grid.nodes());
  mean_stress_.resize(grid.cells());
  sort_points();
}

void Classical::set_velocities(const VelocityField& velocity) {
  for (auto& point : points_) {
    const auto v = velocity(point.position);
    point.velocity = {problem().amplitude * v[0], problem().amplitude * v[1]};
  }
}

void Classical::take_steps(std::int64_t first, int steps, Averages* averages) {
  for (int i = 0; i < steps; ++i) {
    const auto step = first + i;
    locate_points(step);
    extrapolate_momenta(step - 1);
    update_strains();
    averages[i] = this->averages();
    find_forces(step);
    update_momenta(step);
    update_points();
    extrapolate_momenta(step);
    update_strains();
  }
}

/// Lets a point that has left a periodic box enter it on the opposite side.
void Classical::bring_back(Point& point, std::int64_t step) const {
  const auto& grid = problem().discretisation.grid();
  const auto periods = [&](double x, int cells) {
    return cells * static_cast<int>(std::floor(x / (cells * grid.cell_side)));
  };
  const int columns = periods(point.position[0], grid.columns), rows = periods(point.position[1], grid.rows);
  if (columns == 0 && rows == 0) return;
  const auto velocity = load_velocity(columns, rows, step - 1);
  point.position[0] -= columns * grid.cell_side;
  point.position[1] -= rows * grid.cell_side;
  point.velocity[0] -= velocity[0];
  point.velocity[1] -= velocity[1];
}

void Classical::locate_points(std::int64_t step) {
  const auto& grid = problem().discretisation.grid();
  const bool wraps = problem().boundary == Boundary::periodic;
  bool sorted = true;
#pragma omp parallel for num_threads(threads_) reduction(&& : sorted)
  for (auto& point : points_) {  // NOLINT(modernize-loop-convert)
    if (wraps) bring_back(point, step);
    const double x = point.position[0] / grid.cell_side, y = point.position[1] / grid.cell_side;
    const double column = std::floor(x), row = std::floor(y);
    const bool inside = column >= 0.0 && row >= 0.0 && column < grid.columns && row < grid.rows;
    const int cell = inside ? static_cast<int>(row) * grid.columns + static_cast<int>(column) : -1;
    sorted = sorted && cell == point.cell;
    point.cell = cell;
    point.local = {x - column - 0.5, y - row - 0.5};
  }
  if (!sorted) sort_points();
}

void Classical::sort_points() {
  const auto& grid = problem().discretisation.grid();
  const auto lost = std::ranges::find(points_, -1, &Point::cell);
  if (lost != points_.end()) {
    throw NumericalError(fmt::format(
        "dynamic run: the point that started at ({:.4g}, {:.4g}) m left the grid at step {}; "
        "likely cause: too large a time step or too large an amplitude",
        lost->position[0] - lost->displacement[0], lost->position[1] - lost->displacement[1], steps_taken()));
  }
  std::ranges::stable_sort(points_, {}, &Point::cell);
  cell_begin_.assign(grid.cells() + 1, 0);
  for (const auto& point : points_) ++cell_begin_[static_cast<std::size_t>(point.cell) + 1];
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) cell_begin_[cell + 1] += cell_begin_[cell];
}

template <class Action>
void Classical::for_nodes(Action&& action) {
  const auto& grid = problem().discretisation.grid();
#pragma omp parallel for num_threads(threads_)
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column <= grid.columns; ++column) {
      action(nodes_[grid.node_index(column, row)], column, row);
    }
  }
}

template <class Visit>
void Classical::for_points_around(int node_column, int node_row, Visit&& visit) const {
  const auto& grid = problem().discretisation.grid();
  const bool wraps = problem().boundary == Boundary::periodic;
  for (int node = 3; node >= 0; --node) {
    const int column = node_column - (node & 1), row = node_row - (node >> 1);
    const int first = wraps ? (column + grid.columns) % grid.columns : column;
    const int lowest = wraps ? (row + grid.rows) % grid.rows : row;
    if (first < 0 || lowest < 0 || first >= grid.columns || lowest >= grid.rows) continue;
    const auto cell = grid.cell_index(first, lowest);
    for (std::size_t p = cell_begin_[cell]; p < cell_begin_[cell + 1]; ++p) {
      visit(points_[p], shape(static_cast<std::size_t>(node), points_[p].local), column - first, row - lowest);
    }
  }
}

/// Velocity of the affine motion of the load between a step and the next.
Vector<2> Classical::load_velocity(int node_column, int node_row, std::int64_t step) const {
  const double rate = problem().amplitude * (load_at(step + 1) - load_at(step)) / problem().time_step;
  const auto affine = affine_motion(problem(), node_column, node_row);
  return {rate * affine[0], rate * affine[1]};
}

void Classical::extrapolate_momenta(std::int64_t step) {
  for_nodes([&](Node& node, int column, int row) {
    node.mass = 0.0;
    node.momentum = {0.0, 0.0};
    for_points_around(column, row, [&](const Point& point, const Shape& s, int columns_away, int rows_away) {
      const double mass = s.weight * point.mass;
      node.mass += mass;
      node.momentum[0] += mass * point.velocity[0];
      node.momentum[1] += mass * point.velocity[1];
      if (columns_away == 0 && rows_away == 0) return;
      const auto velocity = load_velocity(columns_away, rows_away, step);
      node.momentum[0] += mass * velocity[0];
      node.momentum[1] += mass * velocity[1];
    });
    if (is_prescribed(problem(), column, row)) {
      const auto velocity = load_velocity(column, row, step);
      node.momentum = {node.mass * velocity[0], node.mass * velocity[1]};
    }
    node.velocity = {0.0, 0.0};
    if (node.mass > 0.0) node.velocity = {node.momentum[0] / node.mass, node.momentum[1] / node.mass};
  });
}

std::array<std::size_t, 4> Classical::nodes_of(int cell) const noexcept {
  const auto columns = static_cast<std::size_t>(problem().discretisation.grid().columns);
  const auto c = static_cast<std::size_t>(cell);
  const auto corner = c / columns * (columns + 1) + c % columns;
  return {corner, corner + 1, corner + columns + 1, corner + columns + 2};
}

std::array<double, 3> Classical::strain_step(const Point& point) const {
  const double scale = 0.5 * problem().time_step / problem().discretisation.grid().cell_side;
  const auto nodes = nodes_of(point.cell);
  std::array<double, 3> step = {0.0, 0.0, 0.0};
  for (std::size_t node = 0; node < 4; ++node) {
    const auto s = shape(node, point.local);
    const auto& v = nodes_[nodes[node]].velocity;
    step[0] += scale * s.dx * v[0];
    step[1] += scale * s.dy * v[1];
    step[2] += scale * (s.dy * v[0] + s.dx * v[1]);
  }
  return step;
}

double Classical::mean_volumetric_step(int cell) const {
  const auto c = static_cast<std::size_t>(cell);
  double sum = 0.0;
  for (std::size_t p = cell_begin_[c]; p < cell_begin_[c + 1]; ++p) {
    const auto step = strain_step(points_[p]);
    sum += step[0] + step[1];
  }
  return sum / static_cast<double>(cell_begin_[c + 1] - cell_begin_[c]);
}

void Classical::update_strains() {
  const bool averaged = problem().volumetric == Volumetric::averaged;
  const auto cells = static_cast<int>(mean_stress_.size());
#pragma omp parallel for num_threads(threads_)
  for (int cell = 0; cell < cells; ++cell) {
    const auto c = static_cast<std::size_t>(cell);
    if (cell_begin_[c] == cell_begin_[c + 1]) continue;
    const double mean = averaged ? mean_volumetric_step(cell) : 0.0;
    for (std::size_t p = cell_begin_[c]; p < cell_begin_[c + 1]; ++p) {
      auto step = strain_step(points_[p]);
      if (averaged) {
        const double missing = mean - (step[0] + step[1]);
        step[0] += 0.5 * missing;
        step[1] += 0.5 * missing;
      }
      update_stress(points_[p], step);
    }
  }
}

void Classical::update_stress(Point& point, const std::array<double, 3>& strain_step) {
  const auto& material = materials_[point.material];
  const double volumetric_step = strain_step[0] + strain_step[1];
  for (std::size_t i = 0; i < 3; ++i) point.strain[i] += strain_step[i];
  const auto deviator = [](const std::array<double, 3>& e) -> std::array<double, 3> {
    return {4.0 / 3.0 * e[0] - 2.0 / 3.0 * e[1], 4.0 / 3.0 * e[1] - 2.0 / 3.0 * e[0], e[2]};
  };
  const auto total = deviator(point.strain), step = deviator(strain_step);
  for (std::size_t i = 0; i < 3; ++i) point.deviator[i] = material.shear * total[i];
  point.pressure = material.bulk * (point.strain[0] + point.strain[1]);
  double* history = history_.data() + point.history;
  for (const auto& [decay, gain] : material.shear_terms) {
    for (std::size_t i = 0; i < 3; ++i, ++history) {
      *history = decay * *history + gain * step[i];
      point.deviator[i] += *history;
    }
  }
  for (const auto& [decay, gain] : material.bulk_terms) {
    *history = decay * *history + gain * volumetric_step;
    point.pressure += *history++;
  }
}

void Classical::find_forces(std::int64_t step) {
  const double h = problem().discretisation.grid().cell_side;
  const bool averaged = problem().volumetric == Volumetric::averaged;
  if (averaged) {
    for (std::size_t cell = 0; cell < mean_stress_.size(); ++cell) {
      double sum = 0.0;
      for (std::size_t p = cell_begin_[cell]; p < cell_begin_[cell + 1]; ++p) {
        sum += points_[p].pressure + 0.5 * (points_[p].deviator[0] + points_[p].deviator[1]);
      }
      const auto count = cell_begin_[cell + 1] - cell_begin_[cell];
      mean_stress_[cell] = count > 0 ? sum / static_cast<double>(count) : 0.0;
    }
  }
  const bool is_pulled = problem().boundary == Boundary::traction;
  const double pull = problem().amplitude * load_at(step);
  for_nodes([&](Node& node, int column, int row) {
    node.force = {0.0, 0.0};
    if (is_pulled) {
      const auto force = traction_force(problem(), column, row);
      node.force = {pull * force[0], pull * force[1]};
    }
    for_points_around(column, row, [&](const Point& point, const Shape& s, int, int) {
      const auto& [sxx, syy, sxy] = point.deviator;
      // The mean in-plane stress of averaged points works on the mean volumetric strain of the cell.
      const double pressure =
          averaged ? mean_stress_[static_cast<std::size_t>(point.cell)] - 0.5 * (sxx + syy) : point.pressure;
      const double volume_over_side = 0.25 * h;
      node.force[0] -= volume_over_side * ((pressure + sxx) * s.dx + sxy * s.dy);
      node.force[1] -= volume_over_side * (sxy * s.dx + (pressure + syy) * s.dy);
    });
  });
}

void Classical::update_momenta(std::int64_t step) {
  const double dt = problem().time_step;
  const bool follows = follows_affinely(problem());
  for_nodes([&](Node& node, int column, int row) {
    node.acceleration = {0.0, 0.0};
    if (node.mass == 0.0) return;
    const auto before = load_velocity(column, row, step - 1), after = load_velocity(column, row, step);
    const bool prescribed = is_prescribed(problem(), column, row);
    for (std::size_t i = 0; i < 2; ++i) {
      double acceleration = node.force[i] / node.mass;
      if (prescribed) {
        acceleration = (after[i] - before[i]) / dt;
      } else if (follows) {
        acceleration += (after[i] - before[i]) / dt;
      }
      node.acceleration[i] = acceleration;
      node.velocity[i] += dt * acceleration;
    }
  });
}

void Classical::update_points() {
  const double dt = problem().time_step;
#pragma omp parallel for num_threads(threads_)
  for (auto& point : points_) {  // NOLINT(modernize-loop-convert)
    const auto nodes = nodes_of(point.cell);
    for (std::size_t node = 0; node < 4; ++node) {
      const double weight = shape(node, point.local).weight;
      for (std::size_t i = 0; i < 2; ++i) {
        point.velocity[i] += dt * weight * nodes_[nodes[node]].acceleration[i];
        const double step = dt * weight * nodes_[nodes[node]].velocity[i];
        point.position[i] += step;
        point.displacement[i] += step;
      }
    }
  }
}

Averages Classical::averages() const {
  const auto& grid = problem().discretisation.grid();
  PlaneStress stress;
  PlaneStrain strain;
  for (const auto& point : points_) {
    stress.xx += point.pressure + point.deviator[0];
    stress.yy += point.pressure + point.deviator[1];
    stress.xy += point.deviator[2];
    strain.xx += point.strain[0];
    strain.yy += point.strain[1];
    strain.xy += 0.5 * point.strain[2];
  }
  const double scale = 1.0 / (static_cast<double>(grid.cells() * points_per_cell) * problem().amplitude);
  return {{scale * stress.xx, scale * stress.yy, scale * stress.xy},
          {scale * strain.xx, scale * strain.yy, scale * strain.xy}};
}

}  // namespace breccia::dynamics
