// The cells in which the points of the classical formulation are. The steps are in classical.cpp.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "dynamics/classical.hpp"

namespace breccia::dynamics {

/// Lets a point that has left a periodic box enter it on the opposite side.
template <int dim>
void Classical<dim>::bring_back(Point& point, std::int64_t step) const {
  const auto& grid = problem().discretisation.grid();
  Index<dim> away{};
  for (std::size_t axis = 0; axis < away.size(); ++axis) {
    const int cells = grid.cells[axis];
    away[axis] = cells * static_cast<int>(std::floor(point.position[axis] / (cells * grid.cell_side)));
  }
  if (away == Index<dim>{}) return;
  const auto velocity = load_velocity(away, step - 1);
  for (std::size_t axis = 0; axis < away.size(); ++axis) {
    point.position[axis] -= away[axis] * grid.cell_side;
    point.velocity[axis] -= velocity[axis];
  }
}

template <int dim>
void Classical<dim>::locate_points(std::int64_t step) {
  const auto& grid = problem().discretisation.grid();
  const bool wraps = problem().boundary == Boundary::periodic;
  bool sorted = true;
#pragma omp parallel for num_threads(threads_) reduction(&& : sorted)
  for (auto& point : points_) {  // NOLINT(modernize-loop-convert)
    if (wraps) bring_back(point, step);
    Index<dim> cell{};
    bool inside = true;
    for (std::size_t axis = 0; axis < cell.size(); ++axis) {
      const double x = point.position[axis] / grid.cell_side, below = std::floor(x);
      point.local[axis] = x - below - 0.5;
      inside = inside && below >= 0.0 && below < grid.cells[axis];
      if (inside) cell[axis] = static_cast<int>(below);
    }
    const int index = inside ? static_cast<int>(grid.cell_index(cell)) : -1;
    sorted = sorted && index == point.cell;
    point.cell = index;
  }
  if (!sorted) sort_points(step);
}

template <int dim>
void Classical<dim>::sort_points(std::int64_t step) {
  const auto& grid = problem().discretisation.grid();
  const auto lost = std::ranges::find(points_, -1, &Point::cell);
  if (lost != points_.end()) {
    auto start = lost->position;
    for (std::size_t axis = 0; axis < start.size(); ++axis) start[axis] -= lost->displacement[axis];
    throw NumericalError(fmt::format(
        "dynamic run: the point that started at ({:.4g}) m left the grid at step {}; likely cause: too large "
        "a time step or too large an amplitude",
        fmt::join(start, ", "), step));
  }
  std::ranges::stable_sort(points_, {}, &Point::cell);
  cell_begin_.assign(grid.cell_count() + 1, 0);
  for (const auto& point : points_) ++cell_begin_[static_cast<std::size_t>(point.cell) + 1];
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) cell_begin_[cell + 1] += cell_begin_[cell];
}

template void Classical<2>::bring_back(Classical<2>::Point&, std::int64_t) const;
template void Classical<2>::locate_points(std::int64_t);
template void Classical<2>::sort_points(std::int64_t);
template void Classical<3>::bring_back(Classical<3>::Point&, std::int64_t) const;
template void Classical<3>::locate_points(std::int64_t);
template void Classical<3>::sort_points(std::int64_t);

}  // namespace breccia::dynamics
