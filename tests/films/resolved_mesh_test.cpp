#include "films/mesh/resolved_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

#include <gmock/gmock.h>

#include "films/grains_and_films.hpp"
#include "films/mesh/grading.hpp"
#include "films/mesh/node_merger.hpp"

namespace breccia::films {
namespace {

/// The number of elements at each edge, by the node in the middle of the edge.
using Edges = std::map<std::size_t, int>;

template <class Elements>
void count(const Elements& elements, std::size_t corners, std::set<std::size_t>& vertices, Edges& edges) {
  for (const auto& element : elements) {
    for (std::size_t c = 0; c < corners; ++c) {
      vertices.insert(element.nodes[c]);
      ++edges[element.nodes[corners + c]];
    }
  }
}

// In a periodic box, a torus, every edge belongs to two elements, and there are as many edges as vertices and elements.
TEST(ResolvedMesh, IsConforming) {
  for (const double thickness : {test::film_of_25, 0.03}) {
    auto problem = test::voronoi_problem(Boundary::periodic, thickness);
    problem.layers = 3;
    const auto mesh = resolved_mesh(problem);
    std::set<std::size_t> vertices;
    Edges edges;
    count(mesh.grains, 3, vertices, edges);
    count(mesh.triangles, 3, vertices, edges);
    count(mesh.quadrilaterals, 4, vertices, edges);
    EXPECT_TRUE(std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 2; }));
    EXPECT_EQ(vertices.size() + mesh.grains.size() + mesh.triangles.size() + mesh.quadrilaterals.size(), edges.size());
    EXPECT_EQ(vertices.size() + edges.size() + mesh.quadrilaterals.size(), mesh.nodes.size());
  }
}

TEST(GradedDivisions, GrowFromBothEnds) {
  const auto shares = graded_divisions(2.0, 0.01, 0.1);
  ASSERT_GE(shares.size(), 3U);
  EXPECT_EQ(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
  double longest = 0.0;
  for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
    const double element = 2.0 * (shares[k + 1] - shares[k]);
    EXPECT_GT(element, 0.0);
    EXPECT_NEAR(element, 2.0 * (shares[shares.size() - 1 - k] - shares[shares.size() - 2 - k]), 1e-14);
    longest = std::max(longest, element);
  }
  EXPECT_LE(longest, 0.1 + 1e-14);
  EXPECT_LE(2.0 * shares[1], 0.01);
}

TEST(GradedDivisions, OfAShortLineAreTwo) {
  EXPECT_THAT(graded_divisions(1e-3, 0.01, 1e-3), testing::ElementsAre(0.0, 0.5, 1.0));
}

TEST(NodeMerger, TakesImagesForOneNodeInAPeriodicBox) {
  NodeMerger<2> periodic(Walls::periodic);
  EXPECT_EQ(periodic.number({0.0, 0.25}), 0U);
  EXPECT_EQ(periodic.number({0.0, 0.75}), 1U);
  EXPECT_EQ(periodic.number({1.0, 0.25}), 0U);
  EXPECT_EQ(periodic.number({1.0 - 1e-15, -0.75}), 0U);
  EXPECT_EQ(periodic.positions().size(), 2U);
  NodeMerger<2> walled(Walls::hard);
  EXPECT_EQ(walled.number({0.0, 0.25}), 0U);
  EXPECT_EQ(walled.number({1.0, 0.25}), 1U);
  EXPECT_EQ(walled.number({1e-12, 0.25}), 0U);
}

}  // namespace
}  // namespace breccia::films
