#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "breccia/discretisation/grid.hpp"

#include "aligned_vector.hpp"
#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

/// The unknowns of the total-lagrangian formulation, one row of nodes along x after the other: for each the components
/// of the displacement, those of its increment in the last step, and dt^2 h^(dim - 2) / m. Rows are filled up to whole
/// blocks of the kernel. A layer of nodes is one row in 2 dimensions, and the rows of a plane across z in 3.
template <int dim>
class NodeRows {
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

  explicit NodeRows(const Grid<dim>& grid)
      : stride_(length_of_row(grid)),
        rows_of_layer_(rows_of_layer(grid)),
        values_(length_of_layer(grid) * fields * static_cast<std::size_t>(grid.cells.back() + 1), 0.0) {}

  /// Nodes that a row holds.
  [[nodiscard]] std::size_t stride() const noexcept { return stride_; }
  [[nodiscard]] int rows_of_layer() const noexcept { return rows_of_layer_; }
  /// Nodes that a layer holds.
  [[nodiscard]] std::size_t layer_size() const noexcept { return stride_ * static_cast<std::size_t>(rows_of_layer_); }
  /// Number of the row of a node.
  [[nodiscard]] int row_of(const Index<dim>& node) const noexcept {
    return dim == 2 ? node[1] : node.back() * rows_of_layer_ + node[1];
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

  /// All layers, the same number of values for each.
  [[nodiscard]] std::span<double> values() noexcept { return values_; }
  [[nodiscard]] std::span<const double> values() const noexcept { return values_; }

 private:
  static constexpr std::size_t fields = 2 * dim + 1;

  [[nodiscard]] std::size_t begin(int row, std::size_t which) const noexcept {
    return (static_cast<std::size_t>(row) * fields + which) * stride_;
  }
  template <class Value, class Rows>
  static Components<Value> components(Rows& rows, int row, std::size_t first) noexcept {
    Components<Value> all;
    for (std::size_t i = 0; i < dim; ++i) all[i] = rows.values_.data() + rows.begin(row, first + i);
    return all;
  }

  std::size_t stride_;
  int rows_of_layer_;
  AlignedVector values_;
};

}  // namespace breccia::dynamics
