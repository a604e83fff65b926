#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "breccia/dynamics/dynamic_solver.hpp"

namespace breccia::dynamics {

/// What the rows of nodes, and the rows of cells above them, add to the averages of a few steps. Rows are summed in
/// their order once all are known, whichever thread or process found them.
class RowSums {
 public:
  struct Sums {
    std::array<double, 3> stress = {};  ///< of the points of the row of cells: xx, yy, xy [Pa], times the cell side
    Strain<2> strain = {};  ///< of the row of nodes: its share in the integral of sym(u n) over the boundary [m^2]
  };

  explicit RowSums(const Grid<2>& grid)
      : steps_(steps_kept(grid)), sums_(static_cast<std::size_t>(grid.rows() + 1) * static_cast<std::size_t>(steps_)) {}

  /// Steps that there is room for.
  [[nodiscard]] int steps() const noexcept { return steps_; }
  [[nodiscard]] Sums& of(int row, int step) noexcept { return sums_[place(row, step)]; }
  [[nodiscard]] const Sums& of(int row, int step) const noexcept { return sums_[place(row, step)]; }

  /// All numbers, the same number of them for each row of nodes.
  [[nodiscard]] std::span<double> numbers() noexcept {
    static_assert(sizeof(Sums) == 6 * sizeof(double));
    return {sums_.front().stress.data(), 6 * sums_.size()};
  }
  [[nodiscard]] std::size_t bytes() const noexcept { return sums_.size() * sizeof(Sums); }

 private:
  /// Few enough to leave the caches to the nodes.
  static int steps_kept(const Grid<2>& grid) {
    constexpr int most_sums = 1 << 10;
    return std::max(1, most_sums / (grid.rows() + 1));
  }
  [[nodiscard]] std::size_t place(int row, int step) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(steps_) + static_cast<std::size_t>(step);
  }

  int steps_;
  std::vector<Sums> sums_;
};

/// Averages at a step of the run, the one at a place among those of the sums.
[[nodiscard]] Averages<2> averages_of(const DynamicProblem<2>& problem, const RowSums& sums, int place,
                                      std::int64_t step);

}  // namespace breccia::dynamics
