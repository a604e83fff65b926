#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "breccia/dynamics/dynamic_problem.hpp"

#include "aligned_vector.hpp"
#include "cell_material_table.hpp"
#include "cell_row_kernel.hpp"

namespace breccia::dynamics {

/// Rows of cells [first_row, end_row) of a discretisation as blocks of eight cells, with the histories of their Maxwell
/// terms. Elastic points have no history. Rows are filled up with cells without points.
class BlockLayout {
 public:
  BlockLayout(const DynamicProblem<2>& problem, int first_row, int end_row);

  [[nodiscard]] int blocks_per_row() const noexcept { return blocks_per_row_; }
  [[nodiscard]] const Block* row(int cell_row) const noexcept {
    return blocks_.data() + static_cast<std::ptrdiff_t>(cell_row - first_row_) * blocks_per_row_;
  }

  /// Modulus times strain modes of one material in one cell, summed over its Maxwell terms [Pa times the cell side].
  struct Histories {
    std::array<double, shear_modes> shear{};
    std::array<double, bulk_modes_standard> bulk{};
  };
  [[nodiscard]] Histories histories(int column, int row, PhaseIndex material) const;

  /// All histories, row by row.
  [[nodiscard]] std::span<const double> history() const noexcept { return {history_.data(), history_.size() - lanes}; }
  [[nodiscard]] std::span<double> history() noexcept { return {history_.data(), history_.size() - lanes}; }

  /// Size of the materials, which the kernel reads, and of the histories, which it reads and writes [B].
  [[nodiscard]] std::size_t material_bytes() const noexcept {
    return blocks_.size() * sizeof(Block) + shares_.size() * sizeof(Share) + by_cell_.size() * sizeof(CellMaterials);
  }
  [[nodiscard]] std::size_t history_bytes() const noexcept { return history_.size() * sizeof(double); }

 private:
  void add_block(const DynamicProblem<2>& problem, int row, int first_column);
  /// A block of cells of one material each, if it is one that is not all of the same.
  [[nodiscard]] std::optional<CellMaterials> cells_of_one_material(const Discretisation<2>& discretisation, int row,
                                                                   int first_column) const;
  void place_histories();

  int first_row_;
  int blocks_per_row_;
  int bulk_modes_;
  std::vector<std::vector<TermStep>> terms_;
  std::vector<MaterialStep> materials_;
  std::optional<CellMaterialTable> cell_materials_;  ///< nothing without mixtures
  std::vector<Share> shares_;
  std::vector<CellMaterials> by_cell_;
  std::vector<Block> blocks_;
  AlignedVector history_;
};

}  // namespace breccia::dynamics
