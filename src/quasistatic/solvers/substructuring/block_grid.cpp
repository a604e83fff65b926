#include "quasistatic/solvers/substructuring/block_grid.hpp"

#include <utility>

namespace breccia::quasistatic {
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
  SideRange range = {0, 0};
  for (const auto one : {bottom, top, left, right}) {
    range.begin += range.size;
    const int nodes = (one == bottom || one == top ? block.columns : block.rows) - 1;
    range.size = 2 * nodes + block.of_faces.at(one);
    if (one == side) break;
  }
  return range;
}

std::array<int, 2> ends_of(Side side) {
  constexpr std::array<std::array<int, 2>, 4> ends = {{{0, 1}, {2, 3}, {0, 2}, {1, 3}}};
  return ends.at(side);
}

BlockGrid::BlockGrid(const BlockDivision& division, int rank, const UnknownsOfFaces& faces)
    : BlockGrid(division.blocks_along(0, division.position_of(rank)[0]),
                division.blocks_along(1, division.position_of(rank)[1]), faces) {}

BlockGrid::BlockGrid(BlockRow columns, BlockRow rows, UnknownsOfFaces faces)
    : columns_(std::move(columns)), rows_(std::move(rows)), faces_(std::move(faces)) {
  vertex_columns_ = across() + (columns_.wraps ? 0 : 1);
  vertex_rows_ = up() + (rows_.wraps ? 0 : 1);
  owned_columns_ = vertex_columns_ - (columns_.ends_at_neighbour ? 1 : 0);
  owned_rows_ = vertex_rows_ - (rows_.ends_at_neighbour ? 1 : 0);
  const int edge_count = across() * vertex_rows_ + vertex_columns_ * up();
  const auto edges = static_cast<std::size_t>(edge_count);
  edges_.resize(edges);
  sizes_.assign(edges, 0);
  for (int b = 0; b < blocks(); ++b) {
    const auto [bottom_edge, top_edge, left_edge, right_edge] = edges_of(b);
    edges_[static_cast<std::size_t>(bottom_edge)].upper = b;
    edges_[static_cast<std::size_t>(top_edge)].lower = b;
    for (const int edge : {left_edge, right_edge}) edges_[static_cast<std::size_t>(edge)].is_horizontal = false;
    edges_[static_cast<std::size_t>(left_edge)].upper = b;
    edges_[static_cast<std::size_t>(right_edge)].lower = b;
    const auto shape = block(b);
    for (const auto side : {bottom, top, left, right}) {
      sizes_[static_cast<std::size_t>(edges_of(b).at(side))] = static_cast<int>(side_range(shape, side).size);
    }
    colours_[static_cast<std::size_t>(b % across() % 2 + 2 * (b / across() % 2))].push_back(b);
  }
  first_unknown_.resize(edges);
  int next = 2 * owned_vertices();
  const auto number_edges = [&](bool owned) {
    for (std::size_t e = 0; e < edges; ++e) {
      if (is_owned(static_cast<int>(e)) != owned) continue;
      first_unknown_[e] = next;
      next += sizes_[e];
    }
  };
  number_edges(true);
  owned_unknowns_ = next;
  next += 2 * (vertices() - owned_vertices());
  number_edges(false);
  unknowns_ = next;
}

Block BlockGrid::block(int number) const {
  const auto i = static_cast<std::size_t>(number % across()), j = static_cast<std::size_t>(number / across());
  const auto &x = columns_.cuts, &y = rows_.cuts;
  Block block = {x[i], y[j], x[i + 1] - x[i], y[j + 1] - y[j]};
  if (!faces_) return block;
  const auto count = [&](int column, int row, std::size_t axis) {
    const auto [begin, end] = faces_({column, row}, axis);
    return end - begin;
  };
  for (int column = x[i]; column < x[i + 1]; ++column) {
    block.of_faces[bottom] += count(column, y[j], 0);
    block.of_faces[top] += count(column, y[j + 1], 0);
  }
  for (int row = y[j]; row < y[j + 1]; ++row) {
    block.of_faces[left] += count(x[i], row, 1);
    block.of_faces[right] += count(x[i + 1], row, 1);
  }
  return block;
}

bool BlockGrid::is_owned(int edge) const noexcept {
  const int horizontal = across() * vertex_rows_;
  if (edge < horizontal) return edge / across() < owned_rows_;
  return (edge - horizontal) % vertex_columns_ < owned_columns_;
}

int BlockGrid::vertex(int column, int row) const noexcept {
  if (column < owned_columns_ && row < owned_rows_) return row * owned_columns_ + column;
  // Vertices of the next processes: those of the column at the end, then those of the row at the end.
  if (column == owned_columns_) return owned_vertices() + row;
  return vertices() - owned_columns_ + column;
}

std::array<int, 4> BlockGrid::edges_of(int block) const noexcept {
  const int i = block % across(), j = block / across();
  return {horizontal_edge(i, j), horizontal_edge(i, (j + 1) % vertex_rows_), vertical_edge(i, j),
          vertical_edge((i + 1) % vertex_columns_, j)};
}

std::array<int, 4> BlockGrid::vertices_of(int block) const noexcept {
  const int i = block % across(), j = block / across();
  const int next_i = (i + 1) % vertex_columns_, next_j = (j + 1) % vertex_rows_;
  return {vertex(i, j), vertex(next_i, j), vertex(i, next_j), vertex(next_i, next_j)};
}

std::vector<int> BlockGrid::unknowns_of(int block) const {
  std::vector<int> unknowns;
  for (const int edge : edges_of(block)) {
    for (int i = 0; i < unknowns_of_edge(edge); ++i) unknowns.push_back(first_unknown_of_edge(edge) + i);
  }
  for (const int vertex : vertices_of(block)) {
    unknowns.push_back(first_unknown_of_vertex(vertex));
    unknowns.push_back(first_unknown_of_vertex(vertex) + 1);
  }
  return unknowns;
}

}  // namespace breccia::quasistatic
