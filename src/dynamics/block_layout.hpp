#pragma once

#include <vector>

#include "breccia/dynamics/dynamic_problem.hpp"

#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

/// The cells of a discretisation as blocks of eight, with the history that their Maxwell terms need and nothing for
/// elastic points. Rows are filled up with cells without points.
class BlockLayout {
 public:
  explicit BlockLayout(const DynamicProblem& problem);

  [[nodiscard]] int blocks_per_row() const noexcept { return blocks_per_row_; }
  [[nodiscard]] const Block* row(int cell_row) const noexcept {
    return blocks_.data() + static_cast<std::ptrdiff_t>(cell_row) * blocks_per_row_;
  }

  /// Modulus times strain modes of one material in one cell, summed over its Maxwell terms [Pa times the cell side].
  struct Histories {
    std::array<double, shear_modes> shear{};
    std::array<double, bulk_modes_standard> bulk{};
  };
  [[nodiscard]] Histories histories(int column, int row, MaterialIndex material) const;

 private:
  void add_block(const DynamicProblem& problem, int row, int first_column);

  int blocks_per_row_;
  int bulk_modes_;
  std::vector<std::vector<TermStep>> terms_;
  std::vector<MaterialStep> materials_;
  std::vector<Share> shares_;
  std::vector<Block> blocks_;
  std::vector<double> history_;
};

}  // namespace breccia::dynamics
