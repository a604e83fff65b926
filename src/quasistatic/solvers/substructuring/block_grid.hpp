#pragma once

#include <array>
#include <vector>

#include <Eigen/Dense>

#include "quasistatic/operator/block_division.hpp"
#include "quasistatic/solvers/substructuring/block_unknowns.hpp"

namespace breccia::quasistatic {

/// A rectangle of cells.
struct Block {
  int first_column = 0, first_row = 0, columns = 0, rows = 0;
  std::array<int, 4> of_faces = {};  ///< number of the unknowns of the faces on each Side
};

/// The sides of a block, in the order of its boundary nodes.
enum Side { bottom, top, left, right };

/// Position of a node in its block, in cells from the lower left corner.
struct LocalNode {
  int x, y;
};

/// Boundary nodes of a block: the nodes of the four sides without the vertices, one side after the other with rising
/// coordinates, and then the vertices: lower left, lower right, upper left, upper right.
std::vector<LocalNode> boundary_nodes(const Block& block);

/// Index of the first unknown of a side among the unknowns of the boundary of a block (boundary_unknowns), and their
/// number.
struct SideRange {
  Eigen::Index begin, size;
};
SideRange side_range(const Block& block, Side side);

/// The two vertices at the ends of a side: 0 to 3, in the order of boundary_nodes.
std::array<int, 2> ends_of(Side side);

/// An edge: the nodes that two blocks share, without the vertices, and the faces between them. On the boundary of the
/// box, and where another process has the other block, it has only one block.
struct BlockEdge {
  static constexpr int none = -1;
  int lower = none;  ///< number of the block below or to the left
  int upper = none;  ///< number of the block above or to the right
  bool is_horizontal = true;
};

/// A rectangle of blocks, those of one process, and the numbering of the unknowns between them: first the vertices, x
/// and y in turn, then the edges. Vertices and edges that belong to the next process along an axis are numbered in the
/// same way, after those of this process.
class BlockGrid {
 public:
  /// Blocks along both axes. Rows that wrap around have an even number of blocks, so that four colours are enough for
  /// no two neighbours to have the same one.
  BlockGrid(BlockRow columns, BlockRow rows, UnknownsOfFaces faces = {});
  /// The blocks of a process.
  BlockGrid(const BlockDivision& division, int rank, const UnknownsOfFaces& faces = {});

  [[nodiscard]] int blocks() const noexcept { return across() * up(); }
  [[nodiscard]] Block block(int number) const;
  [[nodiscard]] const UnknownsOfFaces& faces() const noexcept { return faces_; }
  [[nodiscard]] const std::vector<BlockEdge>& edges() const noexcept { return edges_; }
  /// Numbers of the edges of a block, by Side.
  [[nodiscard]] std::array<int, 4> edges_of(int block) const noexcept;
  /// Numbers of the vertices of a block, in the order of boundary_nodes.
  [[nodiscard]] std::array<int, 4> vertices_of(int block) const noexcept;

  /// Number of vertices, and of those that belong to this process, which come first.
  [[nodiscard]] int vertices() const noexcept { return vertex_columns_ * vertex_rows_; }
  [[nodiscard]] int owned_vertices() const noexcept { return owned_columns_ * owned_rows_; }
  /// Number of the vertex, the horizontal and the vertical edge at a position, in blocks from the lower left corner.
  [[nodiscard]] int vertex(int column, int row) const noexcept;
  [[nodiscard]] int horizontal_edge(int column, int row) const noexcept { return row * across() + column; }
  [[nodiscard]] int vertical_edge(int column, int row) const noexcept {
    return across() * vertex_rows_ + row * vertex_columns_ + column;
  }
  /// Whether an edge belongs to this process.
  [[nodiscard]] bool is_owned(int edge) const noexcept;

  [[nodiscard]] const BlockRow& columns() const noexcept { return columns_; }
  [[nodiscard]] const BlockRow& rows() const noexcept { return rows_; }
  /// Number of blocks along both axes.
  [[nodiscard]] int across() const noexcept { return static_cast<int>(columns_.cuts.size()) - 1; }
  [[nodiscard]] int up() const noexcept { return static_cast<int>(rows_.cuts.size()) - 1; }

  /// Number of unknowns of all vertices and edges, and of those that belong to this process, which come first.
  [[nodiscard]] int unknowns() const noexcept { return unknowns_; }
  [[nodiscard]] int owned_unknowns() const noexcept { return owned_unknowns_; }
  /// The first unknown of a vertex, which has two, and of an edge, and the number of an edge's unknowns.
  [[nodiscard]] int first_unknown_of_vertex(int vertex) const noexcept {
    return vertex < owned_vertices() ? 2 * vertex : owned_unknowns_ + 2 * (vertex - owned_vertices());
  }
  [[nodiscard]] int first_unknown_of_edge(int edge) const noexcept {
    return first_unknown_[static_cast<std::size_t>(edge)];
  }
  [[nodiscard]] int unknowns_of_edge(int edge) const noexcept { return sizes_[static_cast<std::size_t>(edge)]; }
  /// Numbers of the unknowns of the boundary of a block, in the order of boundary_unknowns.
  [[nodiscard]] std::vector<int> unknowns_of(int block) const;
  /// Numbers of the blocks, by colour. Blocks of one colour share no unknown.
  [[nodiscard]] const std::array<std::vector<int>, 4>& colours() const noexcept { return colours_; }

 private:
  BlockRow columns_, rows_;
  UnknownsOfFaces faces_;
  int vertex_columns_, vertex_rows_;  ///< columns and rows of vertices
  int owned_columns_, owned_rows_;    ///< columns and rows of vertices that belong to this process
  std::vector<BlockEdge> edges_;
  std::vector<int> sizes_, first_unknown_;  ///< number of unknowns, and first unknown, by edge
  int owned_unknowns_ = 0, unknowns_ = 0;
  std::array<std::vector<int>, 4> colours_;
};

}  // namespace breccia::quasistatic
