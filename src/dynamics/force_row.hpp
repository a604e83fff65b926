#pragma once

#include <array>
#include <cstddef>

#include "aligned_vector.hpp"
#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

/// Storage of the forces of a row of cells on a row of nodes.
class ForceRow {
 public:
  /// All zero.
  explicit ForceRow(std::size_t length) {
    for (auto& component : values_) component.assign(length, 0.0);
  }
  /// For sums of the forces of both cells of a node, which stand in the place of those of the cell to its right. The
  /// others are -0, which changes no bit of a sum, not even the sign of a zero.
  static ForceRow for_sums(std::size_t length) {
    ForceRow row(length);
    row.values_[2].assign(length, -0.0);
    row.values_[3].assign(length, -0.0);
    return row;
  }

  [[nodiscard]] RowForces view() noexcept {
    return {values_[0].data(), values_[1].data(), values_[2].data(), values_[3].data()};
  }

 private:
  std::array<AlignedVector, 4> values_;
};

}  // namespace breccia::dynamics
