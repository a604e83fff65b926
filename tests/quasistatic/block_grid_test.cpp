#include "quasistatic/solvers/substructuring/block_grid.hpp"

#include <algorithm>
#include <map>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "test_names.hpp"

namespace breccia::quasistatic {
namespace {

using Node = std::pair<int, int>;

struct Cells {
  int columns, rows;
  bool wraps;
};

std::ostream& operator<<(std::ostream& stream, const Cells& cells) {
  return stream << cells.columns << " x " << cells.rows << (cells.wraps ? ", periodic" : "");
}

/// A node of the boundary of a block, by its position in the box: opposite sides of a periodic box are the same nodes.
Node position_of(const Cells& cells, const Block& block, const LocalNode& node) {
  const int column = block.first_column + node.x, row = block.first_row + node.y;
  return cells.wraps ? Node{column % cells.columns, row % cells.rows} : Node{column, row};
}

TEST(BoundaryNodes, AreTheSidesAndThenTheVertices) {
  std::vector<Node> nodes;
  for (const auto& [x, y] : boundary_nodes({.first_column = 7, .first_row = 9, .columns = 3, .rows = 2})) {
    nodes.emplace_back(x, y);
  }
  const std::vector<Node> expected = {{1, 0}, {2, 0}, {1, 2}, {2, 2}, {0, 1}, {3, 1}, {0, 0}, {3, 0}, {0, 2}, {3, 2}};
  EXPECT_EQ(nodes, expected);
}

TEST(SideRange, FindsTheNodesOfASideAmongThoseOfTheBoundary) {
  const Block block = {0, 0, 4, 3};
  const auto nodes = boundary_nodes(block);
  const auto is_on = [&](Side side, const LocalNode& node) {
    if (side == bottom || side == top) return node.y == (side == bottom ? 0 : block.rows);
    return node.x == (side == left ? 0 : block.columns);
  };
  for (const auto side : {bottom, top, left, right}) {
    const auto [begin, size] = side_range(block, side);
    EXPECT_EQ(size, 2 * ((side == bottom || side == top ? block.columns : block.rows) - 1));
    for (Eigen::Index i = begin; i < begin + size; ++i) {
      EXPECT_TRUE(is_on(side, nodes[static_cast<std::size_t>(i / 2)])) << side;
    }
    for (const int end : ends_of(side)) {
      EXPECT_TRUE(is_on(side, nodes[nodes.size() - 4 + static_cast<std::size_t>(end)])) << side;
    }
  }
}

class Grids : public testing::TestWithParam<Cells> {
 protected:
  Cells cells_ = GetParam();
  BlockGrid grid_{BlockDivision::among(1, {cells_.columns, cells_.rows}, cells_.wraps).value(), 0};
};

TEST_P(Grids, BlocksCoverEveryCellOnceInPiecesOfAboutEight) {
  std::map<Node, int> covered;
  for (int b = 0; b < grid_.blocks(); ++b) {
    const auto block = grid_.block(b);
    EXPECT_LE(std::max(block.columns, block.rows), 13);
    for (int row = 0; row < block.rows; ++row) {
      for (int column = 0; column < block.columns; ++column) {
        ++covered[{block.first_column + column, block.first_row + row}];
      }
    }
  }
  EXPECT_EQ(covered.size(), static_cast<std::size_t>(cells_.columns) * static_cast<std::size_t>(cells_.rows));
  for (const auto& [cell, times] : covered) EXPECT_EQ(times, 1) << cell.first << ", " << cell.second;
}

TEST_P(Grids, AnUnknownIsOneComponentOfOneNodeBetweenBlocks) {
  std::map<int, std::pair<Node, int>> nodes;
  std::map<std::pair<Node, int>, int> unknowns;
  for (int b = 0; b < grid_.blocks(); ++b) {
    const auto block = grid_.block(b);
    const auto boundary = boundary_nodes(block);
    const auto numbers = grid_.unknowns_of(b);
    ASSERT_EQ(numbers.size(), 2 * boundary.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::pair component = {position_of(cells_, block, boundary[i / 2]), static_cast<int>(i % 2)};
      EXPECT_EQ(nodes.emplace(numbers[i], component).first->second, component);
      EXPECT_EQ(unknowns.emplace(component, numbers[i]).first->second, numbers[i]);
    }
  }
  EXPECT_EQ(static_cast<int>(nodes.size()), grid_.unknowns());
  EXPECT_EQ(nodes.begin()->first, 0);
  EXPECT_EQ(nodes.rbegin()->first, grid_.unknowns() - 1);
}

TEST_P(Grids, UnknownsOfVerticesComeFirst) {
  for (int b = 0; b < grid_.blocks(); ++b) {
    const auto numbers = grid_.unknowns_of(b);
    std::vector<int> of_vertices;
    for (const int vertex : grid_.vertices_of(b)) {
      of_vertices.push_back(2 * vertex);
      of_vertices.push_back(2 * vertex + 1);
    }
    EXPECT_TRUE(std::equal(of_vertices.begin(), of_vertices.end(), numbers.end() - 8));
    for (auto u = numbers.begin(); u != numbers.end() - 8; ++u) EXPECT_GE(*u, 2 * grid_.vertices());
  }
}

TEST_P(Grids, BlocksOfOneColourShareNoUnknown) {
  int blocks = 0;
  for (const auto& colour : grid_.colours()) {
    std::set<int> taken;
    for (const int b : colour) {
      ++blocks;
      const auto numbers = grid_.unknowns_of(b);
      const std::set<int> own(numbers.begin(), numbers.end());
      for (const int u : own) EXPECT_TRUE(taken.insert(u).second) << u;
    }
  }
  EXPECT_EQ(blocks, grid_.blocks());
}

TEST_P(Grids, AnEdgeKnowsTheBlocksOnBothSides) {
  for (int b = 0; b < grid_.blocks(); ++b) {
    const auto edges = grid_.edges_of(b);
    const auto edge = [&](Side side) { return grid_.edges()[static_cast<std::size_t>(edges.at(side))]; };
    EXPECT_EQ(edge(bottom).upper, b);
    EXPECT_EQ(edge(top).lower, b);
    EXPECT_EQ(edge(left).upper, b);
    EXPECT_EQ(edge(right).lower, b);
    EXPECT_TRUE(edge(bottom).is_horizontal && edge(top).is_horizontal);
    EXPECT_FALSE(edge(left).is_horizontal || edge(right).is_horizontal);
  }
}

INSTANTIATE_TEST_SUITE_P(Boxes, Grids,
                         testing::Values(Cells{20, 9, false}, Cells{1, 1, false}, Cells{64, 33, false},
                                         Cells{20, 17, true}, Cells{2, 2, true}, Cells{40, 16, true}),
                         breccia::test::by_value);

}  // namespace
}  // namespace breccia::quasistatic
