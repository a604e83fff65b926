#include "quasistatic/solvers/substructuring/substructures.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>

#include "parallel/session.hpp"

namespace breccia::quasistatic {
namespace {

/// Appends the bytes of a number to the signature that distinguishes kinds of blocks.
template <class Number>
void append(std::string& signature, Number number) {
  signature.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

/// The unknowns of the faces of a box.
UnknownsOfFaces unknowns_of_faces(const ElasticOperator<2>& elastic_operator) {
  if (!elastic_operator.has_gaps()) return {};
  return [&cells = elastic_operator.gap_cells()](const Index<2>& node, std::size_t axis) {
    return cells.unknowns_at(node, axis);
  };
}

}  // namespace

Substructures::Substructures(const ElasticOperator<2>& elastic_operator)
    : Substructures(elastic_operator, BlockDivision::among(parallel::ranks(), elastic_operator.grid().cells,
                                                           elastic_operator.boundary() == Boundary::periodic)
                                          .value()) {}

Substructures::Substructures(const ElasticOperator<2>& elastic_operator, const BlockDivision& division)
    : elastic_operator_(&elastic_operator),
      grid_(division, parallel::rank(), unknowns_of_faces(elastic_operator)),
      edges_between_processes_(quasistatic::edges_between_processes(grid_)),
      shared_boundaries_(quasistatic::shared_boundaries(division, parallel::rank(), grid_.faces())),
      shared_unknowns_(quasistatic::shared_unknowns(grid_, shared_boundaries_)),
      shared_edges_(quasistatic::shared_edges(division, parallel::rank(), shared_boundaries_)) {
  first_unknown_ = {0};
  sort_blocks();
  sort_edges();
  sort_blocks_with_neighbours();
}

void Substructures::sort_blocks() {
  std::unordered_map<std::string, int> known;
  kind_of_.reserve(static_cast<std::size_t>(grid_.blocks()));
  for (int b = 0; b < grid_.blocks(); ++b) {
    const auto block = grid_.block(b);
    std::string signature;
    append(signature, block.columns);
    append_unknowns(b, signature);
    for (int row = 0; row < block.rows; ++row) {
      for (int column = 0; column < block.columns; ++column) {
        append(signature, elastic_operator_->kinds().of({block.first_column + column, block.first_row + row}));
      }
    }
    const auto [kind, is_new] = known.emplace(std::move(signature), static_cast<int>(known.size()));
    if (is_new) {
      blocks_by_kind_.emplace_back();
      shapes_.push_back(block);
    }
    blocks_by_kind_[static_cast<std::size_t>(kind->second)].push_back(b);
    kind_of_.push_back(kind->second);
  }
}

/// Lists the unknowns of the boundary of a block, and adds to its signature whether each of them is held.
void Substructures::append_unknowns(int number, std::string& signature) {
  const auto block = grid_.block(number);
  auto unknowns = grid_.unknowns_of(number);
  const auto on_boundary = boundary_unknowns(block, grid_.faces());
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto& [x, y, component, of_face] = on_boundary[i];
    const bool held = of_face == BlockUnknown::none &&
                      elastic_operator_->is_held({block.first_column + x, block.first_row + y}, component);
    signature.push_back(held ? '1' : '0');
    if (held) unknowns[i] = -1;
  }
  unknowns_.insert(unknowns_.end(), unknowns.begin(), unknowns.end());
  first_unknown_.push_back(unknowns_.size());
}

void Substructures::sort_edges() {
  std::map<std::array<int, 3>, int> known;
  std::vector<bool> is_between(grid_.edges().size(), false);
  for (const int edge : edges_between_processes_) is_between[static_cast<std::size_t>(edge)] = true;
  const auto kind_beside = [&](int block) { return block == BlockEdge::none ? EdgeKind::elsewhere : kind_of(block); };
  for (std::size_t e = 0; e < grid_.edges().size(); ++e) {
    const auto& [lower, upper, is_horizontal] = grid_.edges()[e];
    const EdgeKind kind = {kind_beside(lower), kind_beside(upper), is_horizontal};
    const bool is_one_sided = lower == BlockEdge::none || upper == BlockEdge::none;
    if (is_between[e]) {
      edge_kind_of_.push_back(static_cast<int>(edge_kinds_.size()));
      edge_kinds_.push_back(kind);
    } else if (is_one_sided) {
      edge_kind_of_.push_back(BlockEdge::none);
    } else {
      const auto [found, is_new] = known.emplace(std::array{kind.lower, kind.upper, is_horizontal ? 1 : 0},
                                                 static_cast<int>(edge_kinds_.size()));
      if (is_new) edge_kinds_.push_back(kind);
      edge_kind_of_.push_back(found->second);
    }
  }
}

void Substructures::sort_blocks_with_neighbours() {
  std::map<std::array<int, 5>, int> known;
  for (int b = 0; b < grid_.blocks(); ++b) {
    BlockWithNeighbours block = {kind_of(b), {}};
    const auto edges = grid_.edges_of(b);
    std::transform(edges.begin(), edges.end(), block.edges.begin(), [&](int edge) { return edge_kind_of(edge); });
    const auto& [below, above, before, behind] = block.edges;
    const auto [found, is_new] =
        known.emplace(std::array{block.kind, below, above, before, behind}, static_cast<int>(known.size()));
    if (is_new) blocks_with_neighbours_.push_back(block);
    neighbourhood_of_.push_back(found->second);
  }
}

BlockKind Substructures::block_kind(int kind, const std::vector<CellShape<2>::Stiffness>& cells,
                                    std::span<const Moduli> moduli) const {
  const int example = blocks_by_kind_[static_cast<std::size_t>(kind)].front();
  BlockKind block_kind = {grid_.block(example), {}, {}, grid_.faces()};
  for (int row = 0; row < block_kind.shape.rows; ++row) {
    for (int column = 0; column < block_kind.shape.columns; ++column) {
      const Index<2> cell = {block_kind.shape.first_column + column, block_kind.shape.first_row + row};
      const auto kind_of_cell = elastic_operator_->kinds().of(cell);
      const auto* gap = elastic_operator_->gap_cell(cell);
      block_kind.cells.push_back(gap == nullptr ? &cells[kind_of_cell] : nullptr);
      if (gap == nullptr) continue;
      const auto of_cell = elastic_operator_->kinds().mixed()[kind_of_cell]->moduli(moduli);
      block_kind.with_gaps.push_back(
          {gap, GapOperator<2>(*gap, elastic_operator_->modes()).stiffness(of_cell, moduli)});
    }
  }
  const int* unknowns = unknowns_of(example);
  for (int i = 0; i < unknowns_on_boundary(example); ++i) block_kind.held.push_back(unknowns[i] < 0);
  return block_kind;
}

}  // namespace breccia::quasistatic
