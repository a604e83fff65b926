#pragma once

#include <array>
#include <span>
#include <vector>

#include "block_grid.hpp"
#include "block_stiffness.hpp"
#include "elastic_box.hpp"

namespace breccia::quasistatic {

/// The blocks of a box, and which of them, of their edges, and of both together are alike: the same cells in the same
/// places. What is alike is worked out once. One process holds them all.
class Substructures {
 public:
  explicit Substructures(const ElasticBox& box);

  /// An edge between two blocks of these kinds.
  struct EdgeKind {
    int lower, upper;  ///< kinds of blocks
    bool is_horizontal;
  };
  /// A block among its neighbours.
  struct Surrounded {
    int kind;
    std::array<int, 4> edges;  ///< kinds by Side; BlockEdge::none for one on the boundary of the box
  };

  [[nodiscard]] const BlockGrid& grid() const noexcept { return grid_; }

  /// All blocks of each kind.
  [[nodiscard]] const std::vector<std::vector<int>>& blocks_by_kind() const noexcept { return blocks_by_kind_; }
  [[nodiscard]] int kind_of(int block) const noexcept { return kind_of_[static_cast<std::size_t>(block)]; }
  [[nodiscard]] const Block& shape_of(int kind) const noexcept { return shapes_[static_cast<std::size_t>(kind)]; }

  [[nodiscard]] const std::vector<EdgeKind>& edge_kinds() const noexcept { return edge_kinds_; }
  [[nodiscard]] int edge_kind_of(int edge) const noexcept { return edge_kind_of_[static_cast<std::size_t>(edge)]; }

  [[nodiscard]] const std::vector<Surrounded>& surrounded() const noexcept { return surrounded_; }
  [[nodiscard]] int surrounded_of(int block) const noexcept { return surrounded_of_[static_cast<std::size_t>(block)]; }

  /// Unknowns of the boundary of a block, in the order of boundary_nodes, with -1 for those that are held.
  [[nodiscard]] const int* unknowns_of(int block) const noexcept {
    return unknowns_.data() + first_unknown_[static_cast<std::size_t>(block)];
  }
  [[nodiscard]] int unknowns_on_boundary(int block) const noexcept {
    return static_cast<int>(first_unknown_[static_cast<std::size_t>(block) + 1] -
                            first_unknown_[static_cast<std::size_t>(block)]);
  }
  /// Places in a list that holds the unknowns of the boundaries of all blocks in turn.
  [[nodiscard]] std::size_t first_unknown(int block) const noexcept {
    return first_unknown_[static_cast<std::size_t>(block)];
  }
  [[nodiscard]] std::size_t unknowns_in_all() const noexcept { return unknowns_.size(); }
  [[nodiscard]] bool is_held(int vertex_unknown) const noexcept {
    return vertex_is_held_[static_cast<std::size_t>(vertex_unknown)];
  }

  /// The stiffness of a kind of block, for the stiffnesses of cells by their kind.
  [[nodiscard]] BlockKind block_kind(int kind, const std::vector<CellMatrix>& cells) const;

 private:
  const ElasticBox* box_;
  BlockGrid grid_;
  std::vector<std::size_t> first_unknown_;
  std::vector<int> unknowns_;
  std::vector<bool> vertex_is_held_;
  std::vector<Block> shapes_;
  std::vector<std::vector<int>> blocks_by_kind_;
  std::vector<int> kind_of_;
  std::vector<EdgeKind> edge_kinds_;
  std::vector<int> edge_kind_of_;
  std::vector<Surrounded> surrounded_;
  std::vector<int> surrounded_of_;
};

}  // namespace breccia::quasistatic
