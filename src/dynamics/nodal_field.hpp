#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "breccia/discretisation/grid.hpp"
#include "breccia/parallel/ordered_values.hpp"

#include "discretisation/cell_shape.hpp"
#include "dynamics/aligned_vector.hpp"
#include "dynamics/cell_row_kernel.hpp"

namespace breccia::dynamics {

/// Layers of nodes that a process holds.
struct HeldLayers {
  int first = 0, end = 0;  ///< layers [first, end): those below and above its layers of cells
  int lowest = 0;  ///< and layers [0, lowest): the lowest one of the box, if it is held in addition to the others
};

/// The unknowns of the total-lagrangian formulation that a process holds, one row of nodes along x after the other: for
/// each row the components of the displacement, those of its increment in the last step, and dt^2 h^(dim - 2) / m. Rows
/// are filled up to whole blocks of the kernel, and have the numbers that they have in the whole grid. A layer of nodes
/// is one row in 2 dimensions, and the rows of a plane across z in 3.
template <int dim>
class NodalField {
 public:
  /// The components along a row of nodes.
  template <class Value>
  using Components = std::array<Value*, static_cast<std::size_t>(dim)>;

  /// Nodes that a row of a grid holds, with the filling: all blocks and the node to their right, in whole blocks, and
  /// never close to a multiple of 512 bytes, where rows would compete for the same cache sets.
  [[nodiscard]] static std::size_t length_of_row(const Grid<dim>& grid) {
    const int blocks_per_row = (grid.cells[0] + lanes - 1) / lanes;
    const auto length = static_cast<std::size_t>(blocks_per_row + 1) * lanes;
    return length % 64 == 0 ? length + lanes : length;
  }
  [[nodiscard]] static int rows_of_layer(const Grid<dim>& grid) noexcept {
    if constexpr (dim == 2) {
      return 1;
    } else {
      return grid.cells[1] + 1;
    }
  }
  /// Nodes that a layer of a grid holds, with the filling.
  [[nodiscard]] static std::size_t length_of_layer(const Grid<dim>& grid) {
    return length_of_row(grid) * static_cast<std::size_t>(rows_of_layer(grid));
  }

  NodalField(const Grid<dim>& grid, const HeldLayers& held)
      : stride_(length_of_row(grid)),
        rows_of_layer_(rows_of_layer(grid)),
        held_(held),
        values_(values_of_layer() * static_cast<std::size_t>(held.lowest + held.end - held.first), 0.0) {}

  /// Calls action(layer) for the layers held, from the lowest to the highest.
  template <class Action>
  void for_each_layer(Action&& action) const {
    for (int layer = 0; layer < held_.lowest; ++layer) action(layer);
    for (int layer = held_.first; layer < held_.end; ++layer) action(layer);
  }

  /// Nodes that a row holds.
  [[nodiscard]] std::size_t stride() const noexcept { return stride_; }
  [[nodiscard]] int rows_of_layer() const noexcept { return rows_of_layer_; }
  /// Nodes that a layer holds.
  [[nodiscard]] std::size_t layer_size() const noexcept { return stride_ * static_cast<std::size_t>(rows_of_layer_); }
  /// Number of a row of a layer.
  [[nodiscard]] int row_of(int layer, int row_of_layer) const noexcept { return layer * rows_of_layer_ + row_of_layer; }
  /// Number of the row of a node.
  [[nodiscard]] int row_of(const Index<dim>& node) const noexcept {
    return row_of(node.back(), dim == 2 ? 0 : node[1]);
  }
  /// The forces on a layer of nodes, from a row of the layer on.
  [[nodiscard]] LayerForces<dim> along_row(LayerForces<dim> forces, int row_of_layer) const noexcept {
    for (double*& along : forces.of_axis) along += stride_ * static_cast<std::size_t>(row_of_layer);
    return forces;
  }

  /// Displacements, and increments, of the nodes of a cell.
  [[nodiscard]] typename CellShape<dim>::Values displacement_of_cell(const Index<dim>& cell) const {
    return values_of_cell(cell, 0);
  }
  [[nodiscard]] typename CellShape<dim>::Values increment_of_cell(const Index<dim>& cell) const {
    return values_of_cell(cell, dim);
  }

  [[nodiscard]] Components<double> displacement(int row) noexcept { return components<double>(*this, row, 0); }
  [[nodiscard]] Components<double> increment(int row) noexcept { return components<double>(*this, row, dim); }
  [[nodiscard]] double* step_over_mass(int row) noexcept { return values_.data() + begin(row, 2 * dim); }
  [[nodiscard]] Components<const double> displacement(int row) const noexcept {
    return components<const double>(*this, row, 0);
  }
  [[nodiscard]] Components<const double> increment(int row) const noexcept {
    return components<const double>(*this, row, dim);
  }

  /// The values of all layers held, from the lowest to the highest, with the same number of values for each.
  [[nodiscard]] std::span<double> values() noexcept { return values_; }
  /// The values of the layers [first, end) of nodes.
  [[nodiscard]] std::span<const double> values(int first, int end) const noexcept {
    return std::span(values_).subspan(begin(first * rows_of_layer_, 0),
                                      static_cast<std::size_t>(end - first) * values_of_layer());
  }
  [[nodiscard]] std::size_t values_of_layer() const noexcept { return layer_size() * fields; }
  /// Indices of the values held among those of all layers of the grid.
  [[nodiscard]] parallel::OrderedPlaces indices() const {
    const auto lowest = values_of_layer() * static_cast<std::size_t>(held_.lowest);
    const auto left_out = values_of_layer() * static_cast<std::size_t>(held_.first - held_.lowest);
    return {values_.size(), [=](std::size_t i) { return i < lowest ? i : i + left_out; }};
  }
  [[nodiscard]] std::size_t bytes() const noexcept { return values_.size() * sizeof(double); }

 private:
  static constexpr std::size_t fields = 2 * dim + 1;

  [[nodiscard]] std::size_t begin(int row, std::size_t which) const noexcept {
    const int lowest_rows = held_.lowest * rows_of_layer_, left_out = (held_.first - held_.lowest) * rows_of_layer_;
    const int index = row < lowest_rows ? row : row - left_out;
    return (static_cast<std::size_t>(index) * fields + which) * stride_;
  }
  [[nodiscard]] typename CellShape<dim>::Values values_of_cell(const Index<dim>& cell, std::size_t first) const {
    typename CellShape<dim>::Values values;
    for (int n = 0; n < CellShape<dim>::nodes; ++n) {
      auto node = CellShape<dim>::corner(n);
      for (std::size_t axis = 0; axis < node.size(); ++axis) node[axis] += cell[axis];
      const auto of_row = components<const double>(*this, row_of(node), first);
      for (int i = 0; i < dim; ++i) values[dim * n + i] = of_row[static_cast<std::size_t>(i)][node[0]];
    }
    return values;
  }
  template <class Value, class Rows>
  static Components<Value> components(Rows& rows, int row, std::size_t first) noexcept {
    Components<Value> all;
    for (std::size_t i = 0; i < dim; ++i) all[i] = rows.values_.data() + rows.begin(row, first + i);
    return all;
  }

  std::size_t stride_;
  int rows_of_layer_;
  HeldLayers held_;
  AlignedVector values_;
};

/// Storage of the forces of a layer of cells on a layer of nodes.
template <int dim>
class ForceLayer {
 public:
  /// Zero forces on so many nodes.
  explicit ForceLayer(std::size_t nodes) {
    for (auto& component : values_) component.assign(nodes, 0.0);
  }

  [[nodiscard]] LayerForces<dim> view() noexcept {
    LayerForces<dim> forces{};
    for (std::size_t c = 0; c < values_.size(); ++c) forces.of_axis[c] = values_[c].data();
    return forces;
  }

 private:
  std::array<AlignedVector, static_cast<std::size_t>(dim)> values_;
};

}  // namespace breccia::dynamics
