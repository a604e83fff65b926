#include "block_layout.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "breccia/discretisation/cell_shape.hpp"

#include "maxwell_step.hpp"

namespace breccia::dynamics {

BlockLayout::BlockLayout(const DynamicProblem<2>& problem, int first_row, int end_row)
    : first_row_(first_row),
      blocks_per_row_((problem.discretisation.grid().columns() + lanes - 1) / lanes),
      bulk_modes_(problem.volumetric == Volumetric::averaged ? bulk_modes_averaged : bulk_modes_standard) {
  terms_.reserve(2 * problem.materials.size());
  for (const auto& material : problem.materials) {
    const auto& shear = terms_.emplace_back(maxwell_steps(material.shear, problem.time_step));
    const auto& bulk = terms_.emplace_back(maxwell_steps(material.bulk, problem.time_step));
    materials_.push_back({material.bulk.equilibrium(), material.shear.equilibrium(), shear.data(), bulk.data(),
                          static_cast<int>(shear.size()), static_cast<int>(bulk.size())});
  }
  // While blocks are added, pointers are offsets; both arrays move as they grow.
  for (int row = first_row; row < end_row; ++row) {
    for (int block = 0; block < blocks_per_row_; ++block) add_block(problem, row, block * lanes);
  }
  std::size_t history_size = 0;
  for (const auto& share : shares_) {
    history_size += static_cast<std::size_t>(share.material->shear_term_count * shear_modes +
                                             share.material->bulk_term_count * bulk_modes_) *
                    lanes;
  }
  // One block more, so that shares without history point at something.
  history_.assign(history_size + lanes, 0.0);
  double* history = history_.data();
  const Share* share = shares_.data();
  for (auto& block : blocks_) {
    block.shares = share;
    share += block.share_count;
  }
  for (auto& s : shares_) {
    s.history = history;
    history += (s.material->shear_term_count * shear_modes + s.material->bulk_term_count * bulk_modes_) * lanes;
  }
}

void BlockLayout::add_block(const DynamicProblem<2>& problem, int row, int first_column) {
  const auto& discretisation = problem.discretisation;
  const int columns = std::min(lanes, discretisation.grid().columns() - first_column);
  Block block = {nullptr, 0, false, false};
  for (std::size_t m = 0; m < materials_.size(); ++m) {
    Share share = {&materials_[m], nullptr, {}};
    int points = 0;
    for (int lane = 0; lane < columns; ++lane) {
      const auto& cell = discretisation.cell({first_column + lane, row});
      for (std::size_t p = 0; p < CellShape<2>::points; ++p) {
        if (cell[p] != m) continue;
        share.points[lane] = static_cast<std::uint8_t>(share.points[lane] | (1U << p));
        ++points;
      }
    }
    if (points == 0) continue;
    shares_.push_back(share);
    ++block.share_count;
    block.uniform = points == lanes * CellShape<2>::points;
    block.relaxes = block.relaxes || share.material->shear_term_count + share.material->bulk_term_count > 0;
  }
  blocks_.push_back(block);
}

BlockLayout::Histories BlockLayout::histories(int column, int row, PhaseIndex material) const {
  const Block& block = this->row(row)[column / lanes];
  const int lane = column % lanes;
  Histories sums;
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

}  // namespace breccia::dynamics
