// Sums over the points, and their fields. The steps are in classical.cpp, checkpoints in classical_state.cpp.
#include <cmath>
#include <cstddef>

#include "dynamics/classical.hpp"

namespace breccia::dynamics {
namespace {

/// Index of a point, which has an index in the lattice of all points, in the fields of the whole box.
template <int dim>
std::size_t index_in_fields(const Grid<dim>& grid, std::size_t point) {
  Grid<dim> points = grid;
  for (int& along : points.cells) along *= 2;
  auto cell = points.cell_at(point);
  int number = 0;
  for (std::size_t axis = 0; axis < cell.size(); ++axis) {
    number += (cell[axis] % 2) << axis;
    cell[axis] /= 2;
  }
  return place_in_timed_fields(grid.all_cells(), cell, number);
}

}  // namespace

template <int dim>
Vector<dim> Classical<dim>::momentum() const {
  Vector<dim> sum{};
  for (const auto& point : points_) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += point.mass * point.velocity[i] / problem().amplitude;
  }
  return sum;
}

template <int dim>
Energy Classical<dim>::energy() const {
  require_elastic();
  const double volume = initial_volume_ / static_cast<double>(points_.size());
  Energy energy;
  for (const auto& point : points_) {
    double squared_velocity = 0.0, trace = 0.0;
    for (const double v : point.velocity) squared_velocity += v * v;
    for (std::size_t axis = 0; axis < dim; ++axis) trace += point.strain[axis];
    double work = point.pressure * trace;
    for (std::size_t i = 0; i < components; ++i) work += point.deviator[i] * point.strain[i];
    energy.kinetic += 0.5 * point.mass * squared_velocity;
    energy.strain += 0.5 * volume * work;
  }
  const double squared = problem().amplitude * problem().amplitude;
  return {energy.kinetic / squared, energy.strain / squared};
}

template <int dim>
Footprint Classical<dim>::footprint() const {
  // A step reads the points nine times and writes them four times, the nodes seven and four times, the history twice.
  const auto points = points_.size() * sizeof(Point);
  const auto nodes = nodes_.size() * sizeof(Node);
  const auto history = history_.size() * sizeof(double);
  const auto cells = cell_begin_.size() * sizeof(std::size_t) + mean_stress_.size() * sizeof(double);
  return {.held = problem().discretisation.cells().size() * sizeof(CellPhases<dim>) + points + nodes + history + cells,
          .moved_per_step = 13 * points + 11 * nodes + 4 * history};
}

template <int dim>
LatticeFields<dim> Classical<dim>::fields() const {
  const double scale = 1.0 / problem().amplitude;
  const auto& discretisation = problem().discretisation;
  const auto cells = own_cells(Formulation::classical, discretisation.grid());
  auto fields = zero_timed_fields(discretisation, cells);
  if (fields.phase.empty()) return fields;
  for (const auto& point : points_) {
    const auto index = index_in_fields(discretisation.grid(), point.lattice);
    Vector<dim> displacement{};
    typename decltype(fields.strain)::value_type strain{};
    typename decltype(fields.stress)::value_type stress{};
    for (std::size_t i = 0; i < dim; ++i) {
      displacement[i] = scale * point.displacement[i];
      strain[i] = scale * point.strain[i];
      stress[i] = scale * (point.pressure + point.deviator[i]);
    }
    // The deviator has no trace.
    stress[2] = scale * (point.pressure - point.deviator[0] - point.deviator[1]);
    for (std::size_t i = dim; i < components; ++i) {
      strain[i] = 0.5 * scale * point.strain[i];
      stress[i + 3 - dim] = scale * point.deviator[i];
    }
    put_in_timed_fields<dim>(displacement, fields.displacement[index]);
    put_in_timed_fields<dim>(strain, fields.strain[index]);
    put_in_timed_fields<dim>(stress, fields.stress[index]);
  }
  return fields;
}

template <int dim>
Vector<dim> Classical<dim>::most_moved() const {
  Vector<dim> position{};
  double most = 0.0;
  for (const auto& point : points_) {
    double squared = 0.0;
    for (const double v : point.velocity) squared += v * v;
    const double moved = std::sqrt(squared);
    if (moved <= most) continue;
    most = moved;
    position = point.position;
    if (!std::isfinite(moved)) return position;
  }
  return position;
}

template Vector<2> Classical<2>::momentum() const;
template Energy Classical<2>::energy() const;
template Footprint Classical<2>::footprint() const;
template LatticeFields<2> Classical<2>::fields() const;
template Vector<2> Classical<2>::most_moved() const;
template Vector<3> Classical<3>::momentum() const;
template Energy Classical<3>::energy() const;
template Footprint Classical<3>::footprint() const;
template LatticeFields<3> Classical<3>::fields() const;
template Vector<3> Classical<3>::most_moved() const;

}  // namespace breccia::dynamics
