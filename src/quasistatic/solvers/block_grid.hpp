#pragma once

#include <array>
#include <vector>

#include <Eigen/Dense>

namespace breccia::quasistatic {

/// A rectangle of cells.
struct Block {
  int first_column, first_row, columns, rows;
};

/// The sides of a block, in the order of its boundary nodes.
enum Side { bottom, top, left, right };

/// Place of a node in its block, in cells from the lower left corner.
struct LocalNode {
  int x, y;
};

/// Boundary nodes of a block: the nodes of the four sides without the vertices, side by side with rising coordinates,
/// and then the vertices: lower left, lower right, upper left, upper right.
std::vector<LocalNode> boundary_nodes(const Block& block);

/// Index of the first unknown of a side among the unknowns of the boundary of a block, and their number.
struct SideRange {
  Eigen::Index begin, size;
};
SideRange side_range(const Block& block, Side side);

/// The two vertices at the ends of a side: 0 to 3, in the order of boundary_nodes.
std::array<int, 2> ends_of(Side side);

/// An edge: the nodes that two blocks share, without the vertices. On the boundary of the box it has one block alone.
struct BlockEdge {
  static constexpr int none = -1;
  int lower = none;  ///< number of the block below or to the left
  int upper = none;  ///< number of the block above or to the right
  bool is_horizontal = true;
};

/// A grid of cells cut into blocks of about eight by eight, and the numbering of the unknowns between the blocks: first
/// the vertices, x and y in turn, then the edges.
class BlockGrid {
 public:
  /// A grid that wraps around is that of a periodic box. It has an even number of blocks in each direction, so that
  /// four colours are enough for no two neighbours to have the same one.
  BlockGrid(int columns, int rows, bool wraps);

  [[nodiscard]] int blocks() const noexcept { return across() * up(); }
  [[nodiscard]] Block block(int number) const noexcept;
  [[nodiscard]] const std::vector<BlockEdge>& edges() const noexcept { return edges_; }
  /// Numbers of the edges of a block, by Side.
  [[nodiscard]] std::array<int, 4> edges_of(int block) const noexcept;
  /// Numbers of the vertices of a block, in the order of boundary_nodes.
  [[nodiscard]] std::array<int, 4> vertices_of(int block) const noexcept;
  [[nodiscard]] int vertices() const noexcept { return vertex_columns_ * vertex_rows_; }

  /// Number of unknowns of all vertices and edges.
  [[nodiscard]] int unknowns() const noexcept { return first_unknown_.back(); }
  /// Numbers of the unknowns of the boundary of a block, in the order of boundary_nodes, x and y in turn.
  [[nodiscard]] std::vector<int> unknowns_of(int block) const;
  /// Numbers of the blocks, by colour. Blocks of one colour share no unknown.
  [[nodiscard]] const std::array<std::vector<int>, 4>& colours() const noexcept { return colours_; }

 private:
  [[nodiscard]] int across() const noexcept { return static_cast<int>(columns_.size()) - 1; }
  [[nodiscard]] int up() const noexcept { return static_cast<int>(rows_.size()) - 1; }

  std::vector<int> columns_, rows_;  ///< where blocks begin, and where the last one ends
  int vertex_columns_, vertex_rows_;
  std::vector<BlockEdge> edges_;
  std::vector<int> first_unknown_;  ///< by edge, and the number of all unknowns at the end
  std::array<std::vector<int>, 4> colours_;
};

}  // namespace breccia::quasistatic
