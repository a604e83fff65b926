#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "breccia/microstructure/index.hpp"
#include "breccia/microstructure/vector.hpp"

namespace breccia {

/// Layers of cells [begin, end), rows in two dimensions and planes across z in three; all layers by default.
struct CellLayers {
  int begin = 0;
  int end = std::numeric_limits<int>::max();
};

/// Square or cubic cells that fill the box [0, cells[0] * cell_side] x [0, cells[1] * cell_side] (x ...). Lists of
/// cells, nodes and points begin at the corner with the lowest coordinates; the first axis runs fastest.
template <int dim>
struct Grid {
  Index<dim> cells{};      ///< number of cells along each axis
  double cell_side = 0.0;  ///< h [m]

  [[nodiscard]] std::size_t cell_count() const noexcept { return count(cells, 0); }
  [[nodiscard]] std::size_t node_count() const noexcept { return count(cells, 1); }
  /// Number of nodes along each axis.
  [[nodiscard]] Index<dim> nodes() const noexcept {
    auto nodes = cells;
    for (int& along : nodes) ++along;
    return nodes;
  }
  /// Area [m^2] or volume [m^3] of the box.
  [[nodiscard]] double volume() const noexcept {
    return times_power<dim>(static_cast<double>(cell_count()), cell_side);
  }

  [[nodiscard]] IndexRange<dim> all_cells() const noexcept { return {{}, cells}; }
  /// The cells in these layers, without layers outside the grid.
  [[nodiscard]] IndexRange<dim> cells_of(const CellLayers& layers) const noexcept {
    auto range = all_cells();
    range.begin.back() = std::clamp(layers.begin, 0, cells.back());
    range.end.back() = std::clamp(layers.end, range.begin.back(), cells.back());
    return range;
  }

  /// Index of a cell, or of a node, in a list of all of them.
  [[nodiscard]] std::size_t cell_index(const Index<dim>& cell) const noexcept { return index_in(cell, cells, 0); }
  [[nodiscard]] std::size_t node_index(const Index<dim>& node) const noexcept { return index_in(node, cells, 1); }
  /// The cell with an index in a list of cells.
  [[nodiscard]] Index<dim> cell_at(std::size_t index) const noexcept {
    Index<dim> cell{};
    for (std::size_t axis = 0; axis + 1 < cell.size(); ++axis) {
      const auto along = static_cast<std::size_t>(cells[axis]);
      cell[axis] = static_cast<int>(index % along);
      index /= along;
    }
    cell.back() = static_cast<int>(index);
    return cell;
  }
  /// Index of a material point in a list that follows the lattice of points, which has two points to a cell along each
  /// axis. `point` is the number of the point in its cell: bit 0 is its index (0 or 1) along the first axis, and so on.
  [[nodiscard]] std::size_t point_index(const Index<dim>& cell, int point) const noexcept {
    auto lattice_index = cell, lattice = cells;
    for (std::size_t axis = 0; axis < cells.size(); ++axis) {
      lattice_index[axis] = 2 * cell[axis] + ((point >> axis) & 1);
      lattice[axis] = 2 * cells[axis];
    }
    return index_in(lattice_index, lattice, 0);
  }

  /// Calls action(cell) for all cells, or action(node) for all nodes, in the order of their lists.
  template <class Action>
  void for_each_cell(Action&& action) const {
    for_each_index(Index<dim>{}, cells, action);
  }
  template <class Action>
  void for_each_node(Action&& action) const {
    for_each_index(Index<dim>{}, nodes(), action);
  }

  [[nodiscard]] int columns() const noexcept requires(dim == 2) { return cells[0]; }
  [[nodiscard]] int rows() const noexcept requires(dim == 2) { return cells[1]; }

  friend bool operator==(const Grid&, const Grid&) = default;

 private:
  static std::size_t count(const Index<dim>& along, std::size_t more) noexcept {
    std::size_t count = 1;
    for (const int n : along) count *= static_cast<std::size_t>(n) + more;
    return count;
  }
  static std::size_t index_in(const Index<dim>& index, const Index<dim>& along, std::size_t more) noexcept {
    std::size_t number = 0;
    for (std::size_t axis = index.size(); axis-- > 0;) {
      number = number * (static_cast<std::size_t>(along[axis]) + more) + static_cast<std::size_t>(index[axis]);
    }
    return number;
  }
};

}  // namespace breccia
