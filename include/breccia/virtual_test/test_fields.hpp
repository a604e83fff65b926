#pragma once

#include <variant>
#include <vector>

#include "breccia/discretisation/grid.hpp"
#include "breccia/discretisation/point_fields.hpp"
#include "breccia/films/film_fields.hpp"

namespace breccia {

/// Fields of a test on a grid at rising times: at the points of square cells, or means over cubic cells. Each process
/// has the fields of its own cells.
template <int dim>
struct GridFields {
  Grid<dim> grid;
  std::vector<TimedFields<dim>> at_times;
};

/// Fields of a test of grains and films at rising times.
template <int dim>
struct NetworkFields {
  std::vector<TimedFilmFields<dim>> at_times;
};

/// Fields of a test; without times where no fields were requested.
using TestFields = std::variant<GridFields<2>, GridFields<3>, NetworkFields<2>, NetworkFields<3>>;

/// The times of fields [s].
[[nodiscard]] std::vector<double> times_of(const TestFields& fields);

}  // namespace breccia
