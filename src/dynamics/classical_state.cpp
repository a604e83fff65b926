// Checkpoints of a run of the classical formulation.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "checkpoint/state.hpp"
#include "dynamics/classical.hpp"

namespace breccia::dynamics {
namespace {

/// Visits, in a fixed order, the numbers of a point that change during a run.
template <class Point, class Visit>
void visit_numbers(Point& point, const Visit& visit) {
  for (auto* vector : {&point.position, &point.velocity, &point.displacement, &point.local}) {
    for (auto& value : *vector) visit(value);
  }
  for (auto* tensor : {&point.strain, &point.deviator}) {
    for (auto& value : *tensor) visit(value);
  }
  visit(point.pressure);
}
template <int dim>
constexpr std::size_t numbers_per_point = 4 * dim + 2 * tensor_components<dim> + 1;

/// A number of a checkpoint as an index below `end`. Throws FileError when it is not such an index.
std::size_t index_below(std::size_t end, double number) {
  if (number >= 0.0 && number < static_cast<double>(end) && std::floor(number) == number) {
    return static_cast<std::size_t>(number);
  }
  throw FileError(fmt::format("a checkpoint: expected a whole number from 0 to {}, got {}", end - 1, number));
}

}  // namespace

template <int dim>
void Classical<dim>::save_arrays(StateWriter& state, const std::string& group) const {
  std::vector<double> numbers, indices, cells;
  numbers.reserve(numbers_per_point<dim> * points_.size());
  // The order of the points in a cell is part of the state, since sums are taken in it.
  for (const auto& point : points_) {
    visit_numbers(point, [&](double value) { numbers.push_back(value); });
    indices.push_back(static_cast<double>(point.lattice));
    cells.push_back(static_cast<double>(point.cell));
  }
  state.write(group + "/points", numbers);
  state.write(group + "/places", indices);
  state.write(group + "/cells", cells);
  state.write(group + "/history", history_);
}

template <int dim>
void Classical<dim>::restore_arrays(const StateReader& state, const std::string& group) {
  const auto numbers = state.numbers(group + "/points", numbers_per_point<dim> * points_.size());
  const auto indices = state.numbers(group + "/places", points_.size());
  const auto cells = state.numbers(group + "/cells", points_.size());
  history_ = state.numbers(group + "/history", history_.size());
  std::ranges::sort(points_, {}, &Point::lattice);
  const auto& grid = problem().discretisation.grid();
  std::vector<bool> is_taken(points_.size(), false);
  std::vector<Point> restored;
  auto number = numbers.begin();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto lattice = index_below(problem().discretisation.points(), indices[i]);
    const auto found = std::ranges::lower_bound(points_, lattice, {}, &Point::lattice);
    if (found == points_.end() || found->lattice != lattice) throw FileError("a checkpoint: of other points");
    const auto index = static_cast<std::size_t>(found - points_.begin());
    if (is_taken[index]) throw FileError("a checkpoint: the same point twice");
    is_taken[index] = true;
    auto point = *found;
    visit_numbers(point, [&](double& value) { value = *number++; });
    point.cell = static_cast<int>(index_below(grid.cell_count(), cells[i]));
    restored.push_back(point);
  }
  points_ = std::move(restored);
  sort_points(this->steps_taken());
}

template void Classical<2>::save_arrays(StateWriter&, const std::string&) const;
template void Classical<2>::restore_arrays(const StateReader&, const std::string&);
template void Classical<3>::save_arrays(StateWriter&, const std::string&) const;
template void Classical<3>::restore_arrays(const StateReader&, const std::string&);

}  // namespace breccia::dynamics
