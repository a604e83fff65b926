#include "solvers/block_grid.hpp"

#include <algorithm>

namespace breccia::quasistatic {
namespace {

/// Where to cut a row of cells into about equal pieces of some eight cells, both its ends included.
std::vector<int> cut(int cells, bool wraps) {
  constexpr int wanted = 8;
  int pieces = std::max(1, (cells + wanted / 2) / wanted);
  if (wraps) pieces = std::max(2, pieces / 2 * 2);
  std::vector<int> ends;
  for (int i = 0; i <= pieces; ++i) {
    ends.push_back(static_cast<int>(static_cast<long>(cells) * i / pieces));
  }
  return ends;
}

}  // namespace

std::vector<LocalNode> boundary_nodes(const Block& block) {
  std::vector<LocalNode> nodes;
  for (const int y : {0, block.rows}) {
    for (int x = 1; x < block.columns; ++x) nodes.push_back({x, y});
  }
  for (const int x : {0, block.columns}) {
    for (int y = 1; y < block.rows; ++y) nodes.push_back({x, y});
  }
  for (const int y : {0, block.rows}) {
    for (const int x : {0, block.columns}) nodes.push_back({x, y});
  }
  return nodes;
}

SideRange side_range(const Block& block, Side side) {
  const Eigen::Index horizontal = 2 * (block.columns - 1), vertical = 2 * (block.rows - 1);
  switch (side) {
    case bottom:
      return {0, horizontal};
    case top:
      return {horizontal, horizontal};
    case left:
      return {2 * horizontal, vertical};
    case right:
      break;
  }
  return {2 * horizontal + vertical, vertical};
}

std::array<int, 2> ends_of(Side side) {
  constexpr std::array<std::array<int, 2>, 4> ends = {{{0, 1}, {2, 3}, {0, 2}, {1, 3}}};
  return ends.at(side);
}

BlockGrid::BlockGrid(int columns, int rows, bool wraps) : columns_(cut(columns, wraps)), rows_(cut(rows, wraps)) {
  const int more = wraps ? 0 : 1;
  vertex_columns_ = across() + more;
  vertex_rows_ = up() + more;
  const int horizontal = across() * vertex_rows_;
  const int edges = horizontal + vertex_columns_ * up();
  edges_.resize(static_cast<std::size_t>(edges));
  std::vector<int> sizes(edges_.size(), 0);
  for (int b = 0; b < blocks(); ++b) {
    const auto [bottom_edge, top_edge, left_edge, right_edge] = edges_of(b);
    edges_[static_cast<std::size_t>(bottom_edge)].upper = b;
    edges_[static_cast<std::size_t>(top_edge)].lower = b;
    for (const int edge : {left_edge, right_edge}) edges_[static_cast<std::size_t>(edge)].is_horizontal = false;
    edges_[static_cast<std::size_t>(left_edge)].upper = b;
    edges_[static_cast<std::size_t>(right_edge)].lower = b;
    for (const int edge : {bottom_edge, top_edge}) sizes[static_cast<std::size_t>(edge)] = 2 * (block(b).columns - 1);
    for (const int edge : {left_edge, right_edge}) sizes[static_cast<std::size_t>(edge)] = 2 * (block(b).rows - 1);
    colours_[static_cast<std::size_t>(b % across() % 2 + 2 * (b / across() % 2))].push_back(b);
  }
  first_unknown_ = {2 * vertices()};
  for (const int size : sizes) first_unknown_.push_back(first_unknown_.back() + size);
}

Block BlockGrid::block(int number) const noexcept {
  const auto i = static_cast<std::size_t>(number % across()), j = static_cast<std::size_t>(number / across());
  return {columns_[i], rows_[j], columns_[i + 1] - columns_[i], rows_[j + 1] - rows_[j]};
}

std::array<int, 4> BlockGrid::edges_of(int block) const noexcept {
  const int i = block % across(), j = block / across();
  const int horizontal = across() * vertex_rows_;
  return {j * across() + i, (j + 1) % vertex_rows_ * across() + i, horizontal + j * vertex_columns_ + i,
          horizontal + j * vertex_columns_ + (i + 1) % vertex_columns_};
}

std::array<int, 4> BlockGrid::vertices_of(int block) const noexcept {
  const int i = block % across(), j = block / across();
  const int next_i = (i + 1) % vertex_columns_, next_j = (j + 1) % vertex_rows_;
  return {j * vertex_columns_ + i, j * vertex_columns_ + next_i, next_j * vertex_columns_ + i,
          next_j * vertex_columns_ + next_i};
}

std::vector<int> BlockGrid::unknowns_of(int block) const {
  std::vector<int> unknowns;
  for (const int edge : edges_of(block)) {
    const auto e = static_cast<std::size_t>(edge);
    for (int u = first_unknown_[e]; u < first_unknown_[e + 1]; ++u) unknowns.push_back(u);
  }
  for (const int vertex : vertices_of(block)) {
    unknowns.push_back(2 * vertex);
    unknowns.push_back(2 * vertex + 1);
  }
  return unknowns;
}

}  // namespace breccia::quasistatic
