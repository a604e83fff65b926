#pragma once

#include <cstdint>
#include <utility>

#include "force_row.hpp"
#include "row_step.hpp"
#include "step_counter.hpp"

namespace breccia::dynamics {

/// Neighbouring rows of cells that one thread takes through a step: first sweep(), then, once the forces of the rows of
/// cells beyond its ends are known, the rows of nodes at its ends.
class Band {
 public:
  /// Rows of cells [first, end).
  Band(int first, int end, std::size_t row_length)
      : first_(first),
        end_(end),
        lowest_(row_length),
        bottom_(row_length),
        top_(row_length),
        carried_(row_length),
        highest_(row_length) {}

  [[nodiscard]] int first() const noexcept { return first_; }
  [[nodiscard]] int end() const noexcept { return end_; }
  /// Forces of its first row of cells on the nodes below, and of its last row of cells on the nodes above.
  [[nodiscard]] RowForces lowest_forces() noexcept { return lowest_.view(); }
  [[nodiscard]] RowForces highest_forces() noexcept { return highest_.view(); }

  /// Finds the forces of all rows of cells and moves the rows of nodes between them. Calls after_first_row() when
  /// lowest_forces() are known, and before_last_row() before it reads the row of nodes above its last row of cells.
  template <class AfterFirstRow, class BeforeLastRow>
  void sweep(RowStep& rows, RowSums& sums, int place, std::int64_t step, AfterFirstRow&& after_first_row,
             BeforeLastRow&& before_last_row) {
    for (int row = first_; row < end_; ++row) {
      const bool is_first = row == first_, is_last = row + 1 == end_;
      if (is_last) before_last_row();
      const auto below = (is_first ? lowest_ : bottom_).view();
      rows.find_forces(row, below, (is_last ? highest_ : top_).view(), sums, place);
      if (is_first) after_first_row();
      if (!is_first) rows.move_nodes(row, carried_.view(), below, step);
      std::swap(top_, carried_);
    }
  }

  StepCounter swept;  ///< steps whose forces all of its cells have given
  StepCounter moved;  ///< steps in which its lowest row of nodes has moved, and all above it but the highest

 private:
  int first_, end_;
  ForceRow lowest_;   ///< of the first row of cells on the nodes below
  ForceRow bottom_;   ///< of the present row of cells on the nodes below
  ForceRow top_;      ///< of the present row of cells on the nodes above
  ForceRow carried_;  ///< of the row of cells below on the nodes below the present row of cells
  ForceRow highest_;  ///< of the last row of cells on the nodes above
};

}  // namespace breccia::dynamics
