#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "breccia/discretisation/crystals.hpp"
#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/tensor.hpp"
#include "breccia/parallel/ordered_values.hpp"

namespace breccia {

/// Fields on a lattice, per unit of the load.
template <int dim>
struct LatticeFields {
  static constexpr std::size_t shears = dim * (dim - 1) / 2;

  IndexRange<dim> cells;                  ///< cells of the fields: those of the whole box, or of one process
  std::vector<PhaseIndex> phase;          ///< phase of each value; in a mixture the phase with the largest fraction
  std::vector<Vector<dim>> displacement;  ///< [m]
  /// The strain on which the stress depends: normal components, then tensor shears in Voigt's order (2D: xx, yy, xy)
  /// [-].
  std::vector<std::array<double, dim + shears>> strain;
  /// The stress: three normal components, also in plane strain, then the shears (2D: xx, yy, zz, xy) [Pa].
  std::vector<std::array<double, 3 + shears>> stress;
};

/// Fields at the material points, in the order of their lattice (Grid::point_index): spacing h/2, from the corner with
/// the lowest coordinates. The points of a cell are in neighbouring rows of the lattice.
template <int dim>
using PointFields = LatticeFields<dim>;

/// Means of the fields over the cells, in the order of Grid::cell_index. Fields of all eight points of a cubic cell
/// would take more memory than the solution.
template <int dim>
using CellFields = LatticeFields<dim>;

/// Fields at a time after the load was applied: at the points of square cells (2D), or means over cubic cells (3D).
template <int dim>
struct TimedFields {
  double time = 0.0;  ///< [s]
  LatticeFields<dim> fields;
};

/// Fields of zeros at the points of a discretisation, with the phases of the points. Instantiated for 2 and 3
/// dimensions.
template <int dim>
[[nodiscard]] PointFields<dim> zero_fields(const Discretisation<dim>& discretisation);

/// Fields of zeros in the cells of a discretisation, with the phases of the cells. Where the points of a cell have
/// different phases, the cell has the most frequent one, or the first of equally frequent ones. Instantiated for 2 and
/// 3 dimensions.
template <int dim>
[[nodiscard]] CellFields<dim> zero_cell_fields(const Discretisation<dim>& discretisation);

/// Fields of zeros as in TimedFields::fields, for some cells: at their points in 2D, one value a cell in 3D. Crystals
/// have the phases as which they are shown.
template <int dim>
[[nodiscard]] LatticeFields<dim> zero_timed_fields(const Discretisation<dim>& discretisation,
                                                   const IndexRange<dim>& cells, const Crystals& crystals = {});

/// Index of the values of a point of a cell in the TimedFields::fields of a range of cells.
template <int dim>
[[nodiscard]] std::size_t place_in_timed_fields(const IndexRange<dim>& cells, Index<dim> cell, int point) noexcept {
  if constexpr (dim == 3) return cells.place_of(cell);
  for (std::size_t axis = 0; axis < cell.size(); ++axis) cell[axis] -= cells.begin[axis];
  return Grid<dim>{.cells = cells.size()}.point_index(cell, point);
}

/// Indices of the values in the TimedFields::fields of a range of cells among those of the whole grid.
template <int dim>
[[nodiscard]] parallel::OrderedPlaces places_of_timed_fields(const Grid<dim>& grid, const IndexRange<dim>& cells);

/// Number of the values in the TimedFields::fields of the whole grid.
template <int dim>
[[nodiscard]] std::size_t size_of_timed_fields(const Grid<dim>& grid) noexcept {
  return grid.cell_count() * (dim == 2 ? Discretisation<dim>::points_per_cell : 1);
}

/// Stores the values of a point in TimedFields::fields (2D), or adds its share to the mean of its cell (3D).
template <int dim, std::size_t components>
void put_in_timed_fields(const std::array<double, components>& of_point, std::array<double, components>& values) {
  if constexpr (dim == 2) {
    values = of_point;
  } else {
    for (std::size_t i = 0; i < components; ++i) values[i] += of_point[i] / Discretisation<dim>::points_per_cell;
  }
}

}  // namespace breccia
