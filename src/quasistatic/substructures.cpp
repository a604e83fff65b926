#include "substructures.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>

namespace breccia::quasistatic {
namespace {

/// What tells kinds of blocks apart, as text.
template <class Number>
void append(std::string& text, Number number) {
  text.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

}  // namespace

Substructures::Substructures(const ElasticBox& box)
    : box_(&box), grid_(box.columns(), box.rows(), box.boundary() == Boundary::periodic) {
  const auto count = static_cast<std::size_t>(grid_.blocks());
  first_unknown_ = {0};
  vertex_is_held_.assign(2 * static_cast<std::size_t>(grid_.vertices()), false);
  std::unordered_map<std::string, int> known_blocks;
  kind_of_.reserve(count);
  for (int b = 0; b < grid_.blocks(); ++b) {
    const auto block = grid_.block(b);
    auto unknowns = grid_.unknowns_of(b);
    const auto nodes = boundary_nodes(block);
    std::string signature;
    append(signature, block.columns);
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      const auto& [x, y] = nodes[i / 2];
      const bool held = box.is_held(block.first_column + x, block.first_row + y, static_cast<int>(i % 2));
      signature.push_back(held ? '1' : '0');
      if (!held) continue;
      if (unknowns[i] < 2 * grid_.vertices()) vertex_is_held_[static_cast<std::size_t>(unknowns[i])] = true;
      unknowns[i] = -1;
    }
    for (int row = 0; row < block.rows; ++row) {
      for (int column = 0; column < block.columns; ++column) {
        append(signature, box.kind_of_cell(block.first_column + column, block.first_row + row));
      }
    }
    unknowns_.insert(unknowns_.end(), unknowns.begin(), unknowns.end());
    first_unknown_.push_back(unknowns_.size());
    const auto [kind, is_new] = known_blocks.emplace(std::move(signature), static_cast<int>(known_blocks.size()));
    if (is_new) {
      blocks_by_kind_.emplace_back();
      shapes_.push_back(block);
    }
    blocks_by_kind_[static_cast<std::size_t>(kind->second)].push_back(b);
    kind_of_.push_back(kind->second);
  }

  std::map<std::array<int, 3>, int> known_edges;
  for (const auto& [lower, upper, is_horizontal] : grid_.edges()) {
    if (lower == BlockEdge::none || upper == BlockEdge::none) {
      edge_kind_of_.push_back(BlockEdge::none);
      continue;
    }
    const EdgeKind kind = {kind_of(lower), kind_of(upper), is_horizontal};
    const auto [found, is_new] = known_edges.emplace(std::array{kind.lower, kind.upper, is_horizontal ? 1 : 0},
                                                     static_cast<int>(known_edges.size()));
    if (is_new) edge_kinds_.push_back(kind);
    edge_kind_of_.push_back(found->second);
  }

  std::map<std::array<int, 5>, int> known_surrounded;
  for (int b = 0; b < grid_.blocks(); ++b) {
    Surrounded surrounded = {kind_of(b), {}};
    const auto edges = grid_.edges_of(b);
    std::transform(edges.begin(), edges.end(), surrounded.edges.begin(), [&](int edge) { return edge_kind_of(edge); });
    const auto& [below, above, before, behind] = surrounded.edges;
    const auto [found, is_new] = known_surrounded.emplace(std::array{surrounded.kind, below, above, before, behind},
                                                          static_cast<int>(known_surrounded.size()));
    if (is_new) surrounded_.push_back(surrounded);
    surrounded_of_.push_back(found->second);
  }
}

BlockKind Substructures::block_kind(int kind, const std::vector<CellMatrix>& cells) const {
  const int example = blocks_by_kind_[static_cast<std::size_t>(kind)].front();
  BlockKind made = {grid_.block(example), {}, {}};
  for (int row = 0; row < made.shape.rows; ++row) {
    for (int column = 0; column < made.shape.columns; ++column) {
      made.cells.push_back(&cells[box_->kind_of_cell(made.shape.first_column + column, made.shape.first_row + row)]);
    }
  }
  const int* unknowns = unknowns_of(example);
  for (int i = 0; i < unknowns_on_boundary(example); ++i) made.held.push_back(unknowns[i] < 0);
  return made;
}

}  // namespace breccia::quasistatic
