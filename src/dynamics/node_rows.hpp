#pragma once

#include <cstddef>
#include <span>

#include "breccia/discretisation/grid.hpp"

#include "aligned_vector.hpp"
#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

/// The unknowns of the total-lagrangian formulation, one row of nodes after the other: for each the displacement and
/// its increment in the last step, x and y, and dt^2 / m. Rows are filled up to whole blocks of the kernel.
class NodeRows {
 public:
  /// A pair of components along a row of nodes.
  template <class Value>
  struct Components {
    Value* x;
    Value* y;
  };

  /// Nodes that a row of a grid holds, with the filling: all blocks and the node to their right, in whole blocks, and
  /// never close to a multiple of 512 bytes, where rows would compete for the same cache sets.
  [[nodiscard]] static std::size_t length_of_row(const Grid<2>& grid) {
    const int blocks_per_row = (grid.columns() + lanes - 1) / lanes;
    const auto length = static_cast<std::size_t>(blocks_per_row + 1) * lanes;
    return length % 64 == 0 ? length + lanes : length;
  }

  explicit NodeRows(const Grid<2>& grid)
      : stride_(length_of_row(grid)), values_(stride_ * fields * static_cast<std::size_t>(grid.rows() + 1), 0.0) {}

  /// Nodes that a row holds.
  [[nodiscard]] std::size_t stride() const noexcept { return stride_; }

  [[nodiscard]] Components<double> displacement(int row) noexcept { return {field(row, 0), field(row, 1)}; }
  [[nodiscard]] Components<double> increment(int row) noexcept { return {field(row, 2), field(row, 3)}; }
  [[nodiscard]] double* step_over_mass(int row) noexcept { return field(row, 4); }
  [[nodiscard]] Components<const double> displacement(int row) const noexcept { return {field(row, 0), field(row, 1)}; }
  [[nodiscard]] Components<const double> increment(int row) const noexcept { return {field(row, 2), field(row, 3)}; }

  /// All rows, the same number of values for each.
  [[nodiscard]] std::span<double> values() noexcept { return values_; }
  [[nodiscard]] std::span<const double> values() const noexcept { return values_; }

 private:
  static constexpr std::size_t fields = 5;

  [[nodiscard]] std::size_t begin(int row, std::size_t which) const noexcept {
    return (static_cast<std::size_t>(row) * fields + which) * stride_;
  }
  [[nodiscard]] double* field(int row, std::size_t which) noexcept { return values_.data() + begin(row, which); }
  [[nodiscard]] const double* field(int row, std::size_t which) const noexcept {
    return values_.data() + begin(row, which);
  }

  std::size_t stride_;
  AlignedVector values_;
};

}  // namespace breccia::dynamics
