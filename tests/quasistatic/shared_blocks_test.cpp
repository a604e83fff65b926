#include "quasistatic/solvers/substructuring/shared_blocks.hpp"

#include <array>
#include <map>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "test_names.hpp"

namespace breccia::quasistatic {
namespace {

struct Case {
  int processes;
  std::array<int, 2> cells;
  bool wraps;
};

std::ostream& operator<<(std::ostream& stream, const Case& divided) {
  return stream << divided.processes << " processes, " << divided.cells[0] << " x " << divided.cells[1]
                << (divided.wraps ? ", periodic" : "");
}

/// A component of a node of the box.
using Component = std::array<int, 3>;

class DividedBlocks : public testing::TestWithParam<Case> {
 protected:
  /// The component of a node that each unknown of the interface of a process stands for.
  [[nodiscard]] std::map<int, Component> components_of(const BlockGrid& grid) const {
    std::map<int, Component> components;
    for (int b = 0; b < grid.blocks(); ++b) {
      const auto block = grid.block(b);
      const auto nodes = boundary_nodes(block);
      const auto unknowns = grid.unknowns_of(b);
      for (std::size_t i = 0; i < unknowns.size(); ++i) {
        components[unknowns[i]] = {wrapped(block.first_column + nodes[i / 2].x, 0),
                                   wrapped(block.first_row + nodes[i / 2].y, 1), static_cast<int>(i % 2)};
      }
    }
    return components;
  }

  [[nodiscard]] int wrapped(int node, std::size_t axis) const {
    return divided_.wraps ? node % divided_.cells.at(axis) : node;
  }

  Case divided_ = GetParam();
  BlockDivision division_ = BlockDivision::among(divided_.processes, divided_.cells, divided_.wraps).value();
};

TEST_P(DividedBlocks, CoverEveryCellOnce) {
  std::map<std::pair<int, int>, int> covered;
  for (int rank = 0; rank < divided_.processes; ++rank) {
    const BlockGrid grid(division_, rank);
    EXPECT_GT(grid.blocks(), 0);
    for (int b = 0; b < grid.blocks(); ++b) {
      const auto block = grid.block(b);
      for (int row = 0; row < block.rows; ++row) {
        for (int column = 0; column < block.columns; ++column) {
          ++covered[{block.first_column + column, block.first_row + row}];
        }
      }
    }
  }
  EXPECT_EQ(static_cast<int>(covered.size()), divided_.cells[0] * divided_.cells[1]);
  for (const auto& [cell, times] : covered) EXPECT_EQ(times, 1) << cell.first << ", " << cell.second;
}

TEST_P(DividedBlocks, HaveTheNodesThatBelongToTheirProcess) {
  for (const std::size_t axis : {0U, 1U}) {
    const auto nodes = division_.nodes_along(axis);
    int all = 0;
    for (const int of_process : nodes) all += of_process;
    EXPECT_EQ(all, divided_.cells.at(axis) + (divided_.wraps ? 0 : 1));
  }
}

TEST_P(DividedBlocks, OwnEveryUnknownOnce) {
  std::map<Component, int> owners;
  for (int rank = 0; rank < divided_.processes; ++rank) {
    const BlockGrid grid(division_, rank);
    const auto components = components_of(grid);
    EXPECT_EQ(static_cast<int>(components.size()), grid.unknowns());
    for (const auto& [unknown, component] : components) {
      if (unknown < grid.owned_unknowns()) ++owners[component];
    }
  }
  std::set<Component> all;
  const BlockGrid whole(BlockDivision::among(1, divided_.cells, divided_.wraps).value(), 0);
  for (const auto& [unknown, component] : components_of(whole)) all.insert(component);
  EXPECT_EQ(owners.size(), all.size());
  for (const auto& [component, times] : owners) EXPECT_EQ(times, 1);
}

TEST_P(DividedBlocks, KnowWhereTheUnknownsOfOthersAre) {
  for (int rank = 0; rank < divided_.processes; ++rank) {
    const BlockGrid grid(division_, rank);
    const auto components = components_of(grid);
    std::set<int> copies;
    const auto compare = [&](const SharedBoundary& shared, int first, int count) {
      const auto at_owner = components_of(BlockGrid(division_, shared.owner));
      for (int i = 0; i < count; ++i) {
        copies.insert(first + i);
        EXPECT_EQ(components.at(first + i), at_owner.at(shared.first_unknown_at_owner + i)) << "rank " << rank;
      }
    };
    const auto shared = shared_boundaries(division_, rank);
    for (const auto& vertex : shared.vertices) compare(vertex, grid.first_unknown_of_vertex(vertex.number), 2);
    for (const auto& edge : shared.edges) {
      compare(edge, grid.first_unknown_of_edge(edge.number), grid.unknowns_of_edge(edge.number));
    }
    EXPECT_EQ(static_cast<int>(copies.size()), grid.unknowns() - grid.owned_unknowns());
  }
}

INSTANTIATE_TEST_SUITE_P(Boxes, DividedBlocks,
                         testing::Values(Case{1, {24, 24}, true}, Case{2, {24, 24}, true}, Case{2, {24, 24}, false},
                                         Case{3, {40, 17}, false}, Case{4, {40, 40}, true}, Case{6, {33, 50}, false},
                                         Case{8, {64, 40}, true}, Case{9, {64, 40}, false}, Case{4, {4, 40}, false}),
                         breccia::test::by_value);

// The cuts are those of the blocks of the first process of each row.
TEST(BlockDivision, HasLargerBlocksForMoreProcesses) {
  const auto side = [](int processes) {
    const auto division = BlockDivision::among(processes, {960, 960}, false).value();
    const auto cuts = division.blocks_along(0, 0).cuts;
    return cuts[1] - cuts[0];
  };
  EXPECT_EQ(side(1), 8);
  EXPECT_EQ(side(15), 8);
  EXPECT_EQ(side(16), 16);
  EXPECT_EQ(side(120), 16);
  EXPECT_EQ(side(128), 24);
}

TEST(BlockDivision, NeedsABlockForEveryProcess) {
  EXPECT_FALSE(BlockDivision::among(5, {16, 16}, false));
  EXPECT_FALSE(BlockDivision::among(4, {8, 8}, false));
  EXPECT_TRUE(BlockDivision::among(4, {8, 8}, true));
  EXPECT_TRUE(BlockDivision::among(16, {32, 32}, false)) << "of small blocks";
}

}  // namespace
}  // namespace breccia::quasistatic
