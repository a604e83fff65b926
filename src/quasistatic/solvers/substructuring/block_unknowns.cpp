#include "quasistatic/solvers/substructuring/block_unknowns.hpp"

#include "quasistatic/solvers/substructuring/block_grid.hpp"

namespace breccia::quasistatic {
namespace {

void add_node(int x, int y, std::vector<BlockUnknown>& unknowns) {
  for (int component = 0; component < 2; ++component) unknowns.push_back({x, y, component});
}

void add_face(const Block& block, const UnknownsOfFaces& faces, int x, int y, std::size_t axis,
              std::vector<BlockUnknown>& unknowns) {
  if (!faces) return;
  const auto [begin, end] = faces({block.first_column + x, block.first_row + y}, axis);
  for (auto number = begin; number < end; ++number) unknowns.push_back({x, y, 0, number});
}

}  // namespace

std::vector<BlockUnknown> inside_unknowns(const Block& block, const UnknownsOfFaces& faces) {
  std::vector<BlockUnknown> unknowns;
  for (int y = 0; y < block.rows; ++y) {
    for (int x = 0; x < block.columns; ++x) {
      if (x > 0 && y > 0) add_node(x, y, unknowns);
      if (y > 0) add_face(block, faces, x, y, 0, unknowns);
      if (x > 0) add_face(block, faces, x, y, 1, unknowns);
    }
  }
  return unknowns;
}

std::vector<BlockUnknown> boundary_unknowns(const Block& block, const UnknownsOfFaces& faces) {
  std::vector<BlockUnknown> unknowns;
  for (const int y : {0, block.rows}) {
    for (int x = 1; x < block.columns; ++x) add_node(x, y, unknowns);
    for (int x = 0; x < block.columns; ++x) add_face(block, faces, x, y, 0, unknowns);
  }
  for (const int x : {0, block.columns}) {
    for (int y = 1; y < block.rows; ++y) add_node(x, y, unknowns);
    for (int y = 0; y < block.rows; ++y) add_face(block, faces, x, y, 1, unknowns);
  }
  for (const int y : {0, block.rows}) {
    for (const int x : {0, block.columns}) add_node(x, y, unknowns);
  }
  return unknowns;
}

}  // namespace breccia::quasistatic
