// What a run tells of its state: memory, momentum, energy and fields, and what it goes on from. The steps are in
// classical.cpp.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "breccia/error.hpp"

#include "classical.hpp"

namespace breccia::dynamics {
namespace {

/// Visits, in a fixed order, the numbers of a point that change during a run.
template <class Point, class Visit>
void visit_numbers(Point& point, const Visit& visit) {
  for (auto* pair : {&point.position, &point.velocity, &point.displacement, &point.local}) {
    for (auto& value : *pair) visit(value);
  }
  for (auto* triple : {&point.strain, &point.deviator}) {
    for (auto& value : *triple) visit(value);
  }
  visit(point.pressure);
}
constexpr std::size_t numbers_per_point = 15;

}  // namespace

Vector<2> Classical::momentum() const {
  Vector<2> sum = {0.0, 0.0};
  for (const auto& point : points_) {
    sum[0] += point.mass * point.velocity[0] / problem().amplitude;
    sum[1] += point.mass * point.velocity[1] / problem().amplitude;
  }
  return sum;
}

Energy Classical::energy() const {
  require_elastic();
  const double area = initial_area_ / static_cast<double>(points_.size());
  Energy energy;
  for (const auto& point : points_) {
    const auto& v = point.velocity;
    const auto& e = point.strain;
    const auto& s = point.deviator;
    energy.kinetic += 0.5 * point.mass * (v[0] * v[0] + v[1] * v[1]);
    energy.strain += 0.5 * area * (point.pressure * (e[0] + e[1]) + s[0] * e[0] + s[1] * e[1] + s[2] * e[2]);
  }
  const double squared = problem().amplitude * problem().amplitude;
  return {energy.kinetic / squared, energy.strain / squared};
}

Footprint Classical::footprint() const {
  // A step reads the points nine times and writes them four times, the nodes seven and four times, the history twice.
  const auto points = points_.size() * sizeof(Point);
  const auto nodes = nodes_.size() * sizeof(Node);
  const auto history = history_.size() * sizeof(double);
  const auto cells = cell_begin_.size() * sizeof(std::size_t) + mean_stress_.size() * sizeof(double);
  return {.held = problem().discretisation.cells().size() * sizeof(CellMaterials) + points + nodes + history + cells,
          .moved_per_step = 13 * points + 11 * nodes + 4 * history};
}

PointFields Classical::fields() const {
  const double scale = 1.0 / problem().amplitude;
  auto fields = zero_fields(problem().discretisation);
  for (const auto& point : points_) {
    const auto i = point.lattice;
    const auto& [sxx, syy, sxy] = point.deviator;
    fields.displacement[i] = {scale * point.displacement[0], scale * point.displacement[1]};
    fields.strain[i] = {scale * point.strain[0], scale * point.strain[1], 0.5 * scale * point.strain[2]};
    fields.stress[i] = {scale * (point.pressure + sxx), scale * (point.pressure + syy),
                        scale * (point.pressure - sxx - syy), scale * sxy};
  }
  return fields;
}

Vector<2> Classical::most_moved() const {
  Vector<2> place = {0.0, 0.0};
  double most = 0.0;
  for (const auto& point : points_) {
    const double moved = std::hypot(point.velocity[0], point.velocity[1]);
    if (moved <= most) continue;
    most = moved;
    place = point.position;
    if (!std::isfinite(moved)) return place;
  }
  return place;
}

void Classical::save_arrays(StateWriter& state, const std::string& group) const {
  std::vector<double> numbers, places, cells;
  numbers.reserve(numbers_per_point * points_.size());
  // The order within a cell tells in which points came, and sums are taken in it.
  for (const auto& point : points_) {
    visit_numbers(point, [&](double value) { numbers.push_back(value); });
    places.push_back(static_cast<double>(point.lattice));
    cells.push_back(static_cast<double>(point.cell));
  }
  state.write(group + "/points", numbers);
  state.write(group + "/places", places);
  state.write(group + "/cells", cells);
  state.write(group + "/history", history_);
}

void Classical::restore_arrays(const StateReader& state, const std::string& group) {
  const auto numbers = state.numbers(group + "/points", numbers_per_point * points_.size());
  const auto places = state.numbers(group + "/places", points_.size());
  const auto cells = state.numbers(group + "/cells", points_.size());
  history_ = state.numbers(group + "/history", history_.size());
  std::ranges::sort(points_, {}, &Point::lattice);
  std::vector<Point> restored;
  auto number = numbers.begin();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto place = static_cast<std::size_t>(places[i]);
    const auto found = std::ranges::lower_bound(points_, place, {}, &Point::lattice);
    if (found == points_.end() || found->lattice != place) throw FileError("a checkpoint: of other points");
    auto point = *found;
    visit_numbers(point, [&](double& value) { value = *number++; });
    point.cell = static_cast<int>(cells[i]);
    restored.push_back(point);
  }
  points_ = std::move(restored);
  sort_points();
}

}  // namespace breccia::dynamics
