#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "quasistatic/operator/elastic_operator.hpp"
#include "quasistatic/solvers/substructuring/block_grid.hpp"
#include "quasistatic/solvers/substructuring/block_stiffness.hpp"
#include "quasistatic/solvers/substructuring/shared_blocks.hpp"

namespace breccia::quasistatic {

/// The blocks of cells that substructuring cuts a box into, sorted into kinds. Blocks are of one kind when they have
/// the same cells in the same places; edges, when the blocks on both sides are of the same kinds; blocks with
/// neighbours, when the blocks and their edges are. Data of a kind are computed once. A process holds only its own
/// blocks; an edge between blocks of two processes has a kind of its own.
class Substructures {
 public:
  /// The blocks of this process. There must be enough of them for all processes (BlockDivision).
  explicit Substructures(const ElasticOperator<2>& elastic_operator);

  /// A kind of edge: the kinds of the two blocks that it joins.
  struct EdgeKind {
    static constexpr int elsewhere = -1;
    int lower, upper;  ///< kinds of the blocks below and above, or left and right; `elsewhere` on another process
    bool is_horizontal;
  };
  /// A kind of block together with the kinds of its edges.
  struct BlockWithNeighbours {
    int kind;
    std::array<int, 4> edges;  ///< kinds of edges, by Side; BlockEdge::none on the boundary of the box
  };

  [[nodiscard]] const BlockGrid& grid() const noexcept { return grid_; }
  /// The vertices and edges that belong to other processes.
  [[nodiscard]] const SharedBoundaries& shared_boundaries() const noexcept { return shared_boundaries_; }
  /// Exchange of the unknowns between blocks.
  [[nodiscard]] const SharedValues& shared_unknowns() const noexcept { return shared_unknowns_; }
  /// The edges between processes, and the exchange of values that belong to them.
  [[nodiscard]] const std::vector<int>& edges_between_processes() const noexcept { return edges_between_processes_; }
  [[nodiscard]] const SharedValues& shared_edges() const noexcept { return shared_edges_; }

  /// Numbers of all blocks, by kind.
  [[nodiscard]] const std::vector<std::vector<int>>& blocks_by_kind() const noexcept { return blocks_by_kind_; }
  [[nodiscard]] int kind_of(int block) const noexcept { return kind_of_[static_cast<std::size_t>(block)]; }
  [[nodiscard]] const Block& shape_of(int kind) const noexcept { return shapes_[static_cast<std::size_t>(kind)]; }

  [[nodiscard]] const std::vector<EdgeKind>& edge_kinds() const noexcept { return edge_kinds_; }
  [[nodiscard]] int edge_kind_of(int edge) const noexcept { return edge_kind_of_[static_cast<std::size_t>(edge)]; }

  [[nodiscard]] const std::vector<BlockWithNeighbours>& blocks_with_neighbours() const noexcept {
    return blocks_with_neighbours_;
  }
  [[nodiscard]] int neighbourhood_of(int block) const noexcept {
    return neighbourhood_of_[static_cast<std::size_t>(block)];
  }

  /// Numbers of the unknowns of the boundary of a block, in the order of boundary_unknowns; -1 for held ones.
  [[nodiscard]] const int* unknowns_of(int block) const noexcept {
    return unknowns_.data() + first_unknown_[static_cast<std::size_t>(block)];
  }
  [[nodiscard]] int unknowns_on_boundary(int block) const noexcept {
    return static_cast<int>(first_unknown_[static_cast<std::size_t>(block) + 1] -
                            first_unknown_[static_cast<std::size_t>(block)]);
  }
  /// Index of the first unknown of a block in a list of the boundary unknowns of all blocks, block after block.
  [[nodiscard]] std::size_t first_unknown(int block) const noexcept {
    return first_unknown_[static_cast<std::size_t>(block)];
  }
  /// Length of the list of the boundary unknowns of all blocks.
  [[nodiscard]] std::size_t unknowns_of_all_blocks() const noexcept { return unknowns_.size(); }

  /// A kind of block, with the stiffness matrices of the kinds of cells, and moduli [Pa] for cells with gaps.
  [[nodiscard]] BlockKind block_kind(int kind, const std::vector<CellShape<2>::Stiffness>& cells,
                                     std::span<const Moduli> moduli) const;

 private:
  Substructures(const ElasticOperator<2>& elastic_operator, const BlockDivision& division);
  void sort_blocks();
  void append_unknowns(int number, std::string& signature);
  void sort_edges();
  void sort_blocks_with_neighbours();

  const ElasticOperator<2>* elastic_operator_;
  BlockGrid grid_;
  std::vector<int> edges_between_processes_;
  SharedBoundaries shared_boundaries_;
  SharedValues shared_unknowns_, shared_edges_;
  std::vector<std::size_t> first_unknown_;
  std::vector<int> unknowns_;
  std::vector<Block> shapes_;
  std::vector<std::vector<int>> blocks_by_kind_;
  std::vector<int> kind_of_;
  std::vector<EdgeKind> edge_kinds_;
  std::vector<int> edge_kind_of_;
  std::vector<BlockWithNeighbours> blocks_with_neighbours_;
  std::vector<int> neighbourhood_of_;
};

}  // namespace breccia::quasistatic
