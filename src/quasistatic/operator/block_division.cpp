#include "quasistatic/operator/block_division.hpp"

#include <algorithm>
#include <cstdint>

#include "quasistatic/solvers/substructuring/substructure_side.hpp"

namespace breccia::quasistatic {
namespace {

/// The positions at which a row of cells is cut into about equal pieces of a wanted number of cells, including both
/// ends of the row.
std::vector<int> cut(int cells, int wanted, bool wraps) {
  int pieces = std::max(1, (cells + wanted / 2) / wanted);
  if (wraps) pieces = std::max(2, pieces / 2 * 2);
  std::vector<int> ends;
  for (int i = 0; i <= pieces; ++i) {
    ends.push_back(static_cast<int>(static_cast<long>(cells) * i / pieces));
  }
  return ends;
}

}  // namespace

std::optional<BlockDivision> BlockDivision::among(int processes, const std::array<int, 2>& cells, bool wraps) {
  constexpr int smallest = substructure_side(1);
  for (int side = substructure_side(processes); side >= smallest; side -= smallest) {
    if (auto division = with_blocks(side, processes, cells, wraps)) return division;
  }
  return std::nullopt;
}

std::optional<BlockDivision> BlockDivision::with_blocks(int side, int processes, const std::array<int, 2>& cells,
                                                        bool wraps) {
  const std::array cuts = {cut(cells[0], side, wraps), cut(cells[1], side, wraps)};
  std::optional<BlockDivision> best;
  std::int64_t fewest = 0;
  for (int across = 1; across <= processes; ++across) {
    const int up = processes / across;
    if (across * up != processes) continue;
    if (across >= static_cast<int>(cuts[0].size()) || up >= static_cast<int>(cuts[1].size())) continue;
    const std::int64_t between = std::int64_t{across} * cells[1] + std::int64_t{up} * cells[0];
    if (best && between >= fewest) continue;
    best = BlockDivision({across, up}, cuts, wraps);
    fewest = between;
  }
  return best;
}

std::size_t BlockDivision::first_block(std::size_t axis, int position) const noexcept {
  return (cuts_[axis].size() - 1) * static_cast<std::size_t>(position) / static_cast<std::size_t>(processes_[axis]);
}

BlockRow BlockDivision::blocks_along(std::size_t axis, int position) const {
  const bool is_shared = processes_[axis] > 1;
  const auto begin = cuts_[axis].begin();
  return {.cuts = {begin + static_cast<std::ptrdiff_t>(first_block(axis, position)),
                   begin + static_cast<std::ptrdiff_t>(first_block(axis, position + 1)) + 1},
          .wraps = wraps_ && !is_shared,
          .begins_at_neighbour = is_shared && (wraps_ || position > 0),
          .ends_at_neighbour = is_shared && (wraps_ || position + 1 < processes_[axis])};
}

std::vector<int> BlockDivision::nodes_along(std::size_t axis) const {
  std::vector<int> nodes;
  nodes.reserve(static_cast<std::size_t>(processes_[axis]));
  for (int position = 0; position < processes_[axis]; ++position) {
    nodes.push_back(cuts_[axis][first_block(axis, position + 1)] - cuts_[axis][first_block(axis, position)]);
  }
  if (!wraps_) ++nodes.back();
  return nodes;
}

}  // namespace breccia::quasistatic
