#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "dynamics/aligned_vector.hpp"
#include "dynamics/cell_material_table.hpp"
#include "dynamics/cell_row_kernel.hpp"
#include "dynamics/dynamic_problem.hpp"

namespace breccia::dynamics {

/// Layers of cells [first_layer, end_layer) of a discretisation as blocks of eight cells of a row along x, with the
/// histories of their Maxwell terms. A layer is one row in 2 dimensions, and the rows of a plane across z in 3. Elastic
/// points have no history. Rows are filled up with cells without points.
template <int dim>
class BlockLayout {
 public:
  BlockLayout(const DynamicProblem<dim>& problem, int first_layer, int end_layer);

  [[nodiscard]] int blocks_per_row() const noexcept { return blocks_per_row_; }
  [[nodiscard]] int rows_of_layer() const noexcept { return rows_of_layer_; }
  /// The blocks of a row of a layer.
  [[nodiscard]] const Block* row(int layer, int row_of_layer) const noexcept {
    const int row = layer * rows_of_layer_ + row_of_layer - first_row_;
    return blocks_.data() + static_cast<std::ptrdiff_t>(row) * blocks_per_row_;
  }

  /// Modulus times strain modes of one material in one cell, summed over its Maxwell terms [Pa times the cell side].
  struct Histories {
    std::array<double, static_cast<std::size_t>(shear_modes<dim>)> shear{};
    std::array<double, static_cast<std::size_t>(bulk_modes_standard<dim>)> bulk{};
  };
  [[nodiscard]] Histories histories(const Index<dim>& cell, PhaseIndex material) const;

  /// All histories, row by row and layer by layer.
  [[nodiscard]] std::span<const double> history() const noexcept { return {history_.data(), history_.size() - lanes}; }
  [[nodiscard]] std::span<double> history() noexcept { return {history_.data(), history_.size() - lanes}; }

  /// Size of the materials, which the kernel reads, and of the histories, which it reads and writes [B].
  [[nodiscard]] std::size_t material_bytes() const noexcept {
    return blocks_.size() * sizeof(Block) + shares_.size() * sizeof(Share) + by_cell_.size() * sizeof(CellMaterials);
  }
  [[nodiscard]] std::size_t history_bytes() const noexcept { return history_.size() * sizeof(double); }

 private:
  void add_block(const DynamicProblem<dim>& problem, int row, int first_column);
  /// The materials of a block of cells that have one material each, but not all the same one; nothing for other blocks.
  [[nodiscard]] std::optional<CellMaterials> cells_of_one_material(const Discretisation<dim>& discretisation, int row,
                                                                   int first_column) const;
  void place_histories();

  int rows_of_layer_;
  int first_row_;
  int blocks_per_row_;
  int bulk_modes_;
  std::vector<std::vector<TermStep>> terms_;
  std::vector<MaterialStep> materials_;
  std::optional<CellMaterialTable<dim>> cell_materials_;  ///< table of the materials; nothing without mixtures
  std::vector<Share> shares_;
  std::vector<CellMaterials> by_cell_;
  std::vector<Block> blocks_;
  AlignedVector history_;
};

}  // namespace breccia::dynamics
