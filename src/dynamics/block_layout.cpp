#include "dynamics/block_layout.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "discretisation/cell_shape.hpp"
#include "dynamics/maxwell_step.hpp"

namespace breccia::dynamics {
namespace {

/// Finds the phases of a cell in a row and counts their points.
template <int dim>
const CellPhases<dim>& cell_of(const Discretisation<dim>& discretisation, int row, int column) {
  const auto columns = static_cast<std::size_t>(discretisation.grid().cells[0]);
  return discretisation.cells()[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column)];
}

}  // namespace

template <int dim>
BlockLayout<dim>::BlockLayout(const DynamicProblem<dim>& problem, int first_layer, int end_layer)
    : rows_of_layer_(dim == 2 ? 1 : problem.discretisation.grid().cells[1]),
      first_row_(first_layer * rows_of_layer_),
      blocks_per_row_((problem.discretisation.grid().cells[0] + lanes - 1) / lanes),
      bulk_modes_(problem.volumetric == Volumetric::averaged ? bulk_modes_averaged : bulk_modes_standard<dim>) {
  terms_.reserve(2 * problem.materials.size());
  for (const auto& material : problem.materials) {
    const auto& shear = terms_.emplace_back(maxwell_steps(material.shear, problem.time_step));
    const auto& bulk = terms_.emplace_back(maxwell_steps(material.bulk, problem.time_step));
    materials_.push_back({material.bulk.equilibrium(), material.shear.equilibrium(), shear.data(), bulk.data(),
                          static_cast<int>(shear.size()), static_cast<int>(bulk.size())});
  }
  // Without mixed cells blocks of one material a cell are shared like others.
  if (!problem.discretisation.mixtures().empty()) cell_materials_.emplace(problem.materials, problem.time_step);
  for (int row = first_row_; row < end_layer * rows_of_layer_; ++row) {
    for (int block = 0; block < blocks_per_row_; ++block) add_block(problem, row, block * lanes);
  }
  place_histories();
}

template <int dim>
void BlockLayout<dim>::place_histories() {
  const auto lines_of = [this](const Share& share) {
    return share.material->shear_term_count * shear_modes<dim> + share.material->bulk_term_count * bulk_modes_;
  };
  const auto lines_of_cells = [](const CellMaterials& cells) {
    return cells.shear_term_count * shear_modes<dim> + cells.dilatational_term_count;
  };
  std::size_t lines = 0;
  for (const auto& share : shares_) lines += static_cast<std::size_t>(lines_of(share));
  for (const auto& cells : by_cell_) lines += static_cast<std::size_t>(lines_of_cells(cells));
  // One block more is allocated, so that shares without history have a valid address.
  history_.assign((lines + 1) * lanes, 0.0);
  double* history = history_.data();
  const auto take = [&history](int count) { return std::exchange(history, history + count * lanes); };
  Share* share = shares_.data();
  CellMaterials* cells = by_cell_.data();
  for (auto& block : blocks_) {
    block.shares = share;
    for (int i = 0; i < block.share_count; ++i, ++share) share->history = take(lines_of(*share));
    if (block.by_cell == nullptr) continue;
    cells->history = take(lines_of_cells(*cells));
    block.by_cell = cells++;
  }
}

template <int dim>
std::optional<CellMaterials> BlockLayout<dim>::cells_of_one_material(const Discretisation<dim>& discretisation, int row,
                                                                     int first_column) const {
  if (!cell_materials_) return std::nullopt;
  CellMaterials cells = {};
  bool is_uniform = true;
  for (int lane = 0; lane < lanes; ++lane) {
    auto phase = no_phase;
    if (first_column + lane < discretisation.grid().cells[0]) {
      const auto& phases = cell_of(discretisation, row, first_column + lane);
      phase = phases.front();
      if (std::ranges::any_of(phases, [phase](PhaseIndex other) { return other != phase; })) return std::nullopt;
    }
    const auto& steps = (*cell_materials_)[phase];
    cells.of_lane[lane] = &steps;
    cells.shear_term_count = std::max(cells.shear_term_count, steps.shear_term_count);
    cells.dilatational_term_count = std::max(cells.dilatational_term_count, steps.dilatational_term_count);
    is_uniform = is_uniform && &steps == cells.of_lane[0];
  }
  if (is_uniform) return std::nullopt;
  return cells;
}

template <int dim>
void BlockLayout<dim>::add_block(const DynamicProblem<dim>& problem, int row, int first_column) {
  const auto& discretisation = problem.discretisation;
  const int columns = std::min(lanes, discretisation.grid().cells[0] - first_column);
  Block block = {nullptr, nullptr, 0, false, false};
  if (const auto cells = cells_of_one_material(discretisation, row, first_column)) {
    by_cell_.push_back(*cells);
    block.by_cell = &by_cell_.back();  // place_histories() sets it anew: the list moves as it grows
    block.relaxes = cells->shear_term_count + cells->dilatational_term_count > 0;
    blocks_.push_back(block);
    return;
  }
  for (std::size_t m = 0; m < materials_.size(); ++m) {
    Share share = {&materials_[m], nullptr, {}};
    int points = 0;
    for (int lane = 0; lane < columns; ++lane) {
      const auto& cell = cell_of(discretisation, row, first_column + lane);
      for (std::size_t p = 0; p < CellShape<dim>::points; ++p) {
        if (cell[p] != m) continue;
        share.points[lane] = static_cast<std::uint8_t>(share.points[lane] | (1U << p));
        ++points;
      }
    }
    if (points == 0) continue;
    shares_.push_back(share);
    ++block.share_count;
    block.uniform = points == lanes * CellShape<dim>::points;
    block.relaxes = block.relaxes || share.material->shear_term_count + share.material->bulk_term_count > 0;
  }
  blocks_.push_back(block);
}

template <int dim>
typename BlockLayout<dim>::Histories BlockLayout<dim>::histories(const Index<dim>& cell, PhaseIndex material) const {
  const Block& block = row(cell.back(), dim == 2 ? 0 : cell[1])[cell[0] / lanes];
  const int lane = cell[0] % lanes;
  Histories sums;
  if (block.by_cell != nullptr) {
    const CellMaterials& cells = *block.by_cell;
    const double* history = cells.history + lane;
    for (int k = 0; k < cells.shear_term_count; ++k) {
      for (auto& mode : sums.shear) mode += *history, history += lanes;
    }
    // In plane strain K is the difference of K + G/3 and G/3.
    if constexpr (dim == 2) sums.bulk[0] = -(sums.shear[0] + sums.shear[1]) / 3.0;
    for (int k = 0; k < cells.dilatational_term_count; ++k, history += lanes) sums.bulk[0] += *history;
    return sums;
  }
  for (int i = 0; i < block.share_count; ++i) {
    const Share& share = block.shares[i];
    if (share.material != &materials_[material]) continue;
    const double* history = share.history + lane;
    for (int k = 0; k < share.material->shear_term_count; ++k) {
      for (auto& mode : sums.shear) mode += *history, history += lanes;
    }
    for (int k = 0; k < share.material->bulk_term_count; ++k) {
      for (int mode = 0; mode < bulk_modes_; ++mode, history += lanes)
        sums.bulk[static_cast<std::size_t>(mode)] += *history;
    }
  }
  return sums;
}

template class BlockLayout<2>;
template class BlockLayout<3>;

}  // namespace breccia::dynamics
