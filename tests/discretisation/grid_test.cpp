#include "breccia/discretisation/grid.hpp"

#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace breccia {
namespace {

TEST(Grid, CountsCellsAndNodes) {
  const Grid<2> plane{{3, 2}, 0.5};
  EXPECT_EQ(plane.cell_count(), 6U);
  EXPECT_EQ(plane.node_count(), 12U);
  EXPECT_DOUBLE_EQ(plane.volume(), 1.5);
  const Grid<3> space{{3, 2, 4}, 0.5};
  EXPECT_EQ(space.cell_count(), 24U);
  EXPECT_EQ(space.node_count(), 60U);
  EXPECT_DOUBLE_EQ(space.volume(), 3.0);
}

TEST(Grid, TheFirstAxisRunsFastest) {
  const Grid<3> grid{{3, 2, 4}, 1.0};
  EXPECT_EQ(grid.cell_index({1, 0, 0}), 1U);
  EXPECT_EQ(grid.cell_index({0, 1, 0}), 3U);
  EXPECT_EQ(grid.cell_index({0, 0, 1}), 6U);
  EXPECT_EQ(grid.node_index({0, 1, 0}), 4U);
  EXPECT_EQ(grid.node_index({0, 0, 1}), 12U);
  EXPECT_EQ(grid.node_index({3, 2, 4}), 59U);
  EXPECT_EQ((Grid<2>{{3, 2}, 1.0}.node_index({2, 1})), 6U);
}

TEST(Grid, VisitsCellsAndNodesInTheOrderOfTheirLists) {
  const Grid<3> grid{{3, 2, 4}, 1.0};
  std::size_t cells = 0, nodes = 0;
  grid.for_each_cell([&](const Index<3>& cell) {
    EXPECT_EQ(grid.cell_index(cell), cells);
    EXPECT_EQ(grid.cell_at(cells), cell);
    ++cells;
  });
  grid.for_each_node([&](const Index<3>& node) { EXPECT_EQ(grid.node_index(node), nodes++); });
  EXPECT_EQ(cells, grid.cell_count());
  EXPECT_EQ(nodes, grid.node_count());
}

TEST(Grid, VisitsNothingInAnEmptyRange) {
  int visits = 0;
  for_each_index(Index<3>{0, 2, 0}, Index<3>{3, 2, 4}, [&](const Index<3>&) { ++visits; });
  EXPECT_EQ(visits, 0);
}

TEST(Grid, PointsFollowTheirLattice) {
  // Two cells side by side: the lower row of points is that of points 0 and 1 of both.
  const Grid<2> two{{2, 1}, 1.0};
  EXPECT_EQ(two.point_index({0, 0}, 1), 1U);
  EXPECT_EQ(two.point_index({1, 0}, 0), 2U);
  EXPECT_EQ(two.point_index({0, 0}, 2), 4U);
  const Grid<3> grid{{3, 2, 4}, 1.0};
  std::set<std::size_t> places;
  grid.for_each_cell([&](const Index<3>& cell) {
    for (int p = 0; p < 8; ++p) places.insert(grid.point_index(cell, p));
  });
  EXPECT_EQ(places.size(), 192U);
  EXPECT_EQ(*places.rbegin(), 191U);
  EXPECT_EQ(grid.point_index({0, 0, 0}, 4), 24U) << "one layer of the lattice up";
}

}  // namespace
}  // namespace breccia
