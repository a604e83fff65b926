#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace breccia::quasistatic {

/// The blocks of one process along one axis.
struct BlockRow {
  std::vector<int> cuts;             ///< the first cell of each block, and the end of the last one
  bool wraps = false;                ///< whether the last block has the first one as its neighbour
  bool begins_at_neighbour = false;  ///< whether another process is before the first block
  bool ends_at_neighbour = false;    ///< whether another process is behind the last block
};

/// The division of the cells of a square box into blocks, and of the blocks among a grid of processes: every process
/// has a rectangle of whole blocks. Blocks have about eight by eight cells or, for many processes, more.
class BlockDivision {
 public:
  /// The division with the largest useful blocks for so many processes and, among such divisions, the fewest nodes
  /// between processes; nothing if there are too few blocks for the processes. In a box that wraps around, opposite
  /// sides are neighbours; the number of its blocks along each axis is even.
  static std::optional<BlockDivision> among(int processes, const std::array<int, 2>& cells, bool wraps);

  /// Number of processes along each axis. The first axis is the faster one in the ranks of processes.
  [[nodiscard]] const std::array<int, 2>& processes() const noexcept { return processes_; }
  /// Position of a process in the grid of processes.
  [[nodiscard]] std::array<int, 2> position_of(int rank) const noexcept {
    return {rank % processes_[0], rank / processes_[0]};
  }
  /// Rank of the process at a position, which may be one beyond the last of a box that wraps around.
  [[nodiscard]] int rank_at(const std::array<int, 2>& position) const noexcept {
    return position[1] % processes_[1] * processes_[0] + position[0] % processes_[0];
  }
  /// The blocks of the processes at a position along an axis.
  [[nodiscard]] BlockRow blocks_along(std::size_t axis, int position) const;
  /// Number of nodes along an axis that belong to the processes at each position: the nodes at the beginning of a block
  /// belong to its process, and the nodes at the end of the box to the last process.
  [[nodiscard]] std::vector<int> nodes_along(std::size_t axis) const;

 private:
  /// The division into blocks of about this side.
  static std::optional<BlockDivision> with_blocks(int side, int processes, const std::array<int, 2>& cells, bool wraps);

  BlockDivision(const std::array<int, 2>& processes, std::array<std::vector<int>, 2> cuts, bool wraps)
      : processes_(processes), cuts_(std::move(cuts)), wraps_(wraps) {}

  /// Number of the first block of a position along an axis.
  [[nodiscard]] std::size_t first_block(std::size_t axis, int position) const noexcept;

  std::array<int, 2> processes_;
  std::array<std::vector<int>, 2> cuts_;  ///< cuts of the box along each axis
  bool wraps_;
};

}  // namespace breccia::quasistatic
