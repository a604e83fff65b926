#include "results/meshes/closed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/random_sites.hpp"
#include "breccia/microstructure/tessellation.hpp"

#include "io/text_file.hpp"
#include "microstructure/vector_algebra.hpp"
#include "results/mesh_parsers.hpp"
#include "results/meshes/stl_file.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

/// Expects that every edge is met once in each direction.
void expect_closed(const ClosedSurface& surface) {
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (const auto& triangle : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{triangle[k], triangle[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
}

double longest_edge(const ClosedSurface& surface) {
  double longest = 0.0;
  for (const auto& triangle : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, norm(surface.corners[triangle[(k + 1) % 3]] - surface.corners[triangle[k]]));
    }
  }
  return longest;
}

TEST(ClosedSurface, OfABallHasNoLongerEdgesThanAsked) {
  double before = 0.0;
  for (const double longest : {1.0, 0.3, 0.1, 0.05}) {
    const auto ball = divided_icosahedron(longest);
    expect_closed(ball);
    EXPECT_LE(longest_edge(ball), longest);
    EXPECT_EQ(ball.corners.size(), 2 + ball.triangles.size() / 2) << "Euler's formula";
    for (const auto& corner : ball.corners) EXPECT_NEAR(norm(corner), 0.5, 1e-15);
    const double volume = enclosed_volume(ball) / (std::numbers::pi / 6.0);
    EXPECT_LT(volume, 1.0);
    EXPECT_GT(volume, before);
    EXPECT_NEAR(volume, 1.0, 1.9 * longest * longest) << "the error falls with the square of the edge";
    before = volume;
  }
  EXPECT_THROW(static_cast<void>(divided_icosahedron(1e-3)), InputError);
}

TEST(ClosedSurface, OfAnEllipsoidIsOnIt) {
  const auto ball = divided_icosahedron(0.1);
  const Ellipsoid ellipsoid{{1e-3, 2e-3, 3e-3}, {4e-4, 2e-4, 1e-4}, turned({0.3, -0.8, 0.4, 0.2})};
  const auto surface = surface_of(ellipsoid, ball);
  expect_closed(surface);
  for (const auto& corner : surface.corners) EXPECT_NEAR(signed_distance(ellipsoid, corner), 0.0, 1e-15);
  EXPECT_NEAR(enclosed_volume(surface) / volume(ellipsoid), enclosed_volume(ball) / (std::numbers::pi / 6.0), 1e-12);
}

TEST(ClosedSurface, OfAGrainIsExactAlsoInAFile) {
  RandomTessellationRequest request;
  request.side = 1e-3;
  request.diameters = {1.0, 1.3, 0.7, 1.1, 0.9, 1.6, 0.4, 1.2};
  const Tessellation<3> tessellation(random_sites<3>(request));
  const test::TemporaryDirectory directory;
  StlFile file(directory.path() / "grains.stl", "grains", 1e3);
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    const auto grain = tessellation.grain(site, 1e-5);
    const auto surface = surface_of(grain, tessellation.sites().sites[site].position);
    expect_closed(surface);
    EXPECT_NEAR(enclosed_volume(surface) / volume(grain), 1.0, 1e-12);
    file.add(surface);
  }
  file.commit();
  const auto bytes = read_text(directory.path() / "grains.stl");
  EXPECT_EQ(bytes.substr(0, 6), "grains");
  const auto triangles = test::parse_stl(bytes);
  EXPECT_EQ(triangles.size(), file.triangles());
  const auto bodies = test::closed_bodies(triangles);
  ASSERT_EQ(bodies.size(), tessellation.size());
  for (std::size_t site = 0; site < bodies.size(); ++site) {
    const auto& at = tessellation.sites().sites[site].position;
    EXPECT_NEAR(test::volume_of(bodies[site]) / (1e9 * volume(tessellation.grain(site, 1e-5))), 1.0, 1e-5)
        << "in mm, of single precision";
    for (const auto& [normal, corners] : bodies[site]) {
      double height = 0.0;  // of the face above the site, which is inside the grain or near it
      for (std::size_t axis = 0; axis < 3; ++axis) height += normal[axis] * (corners[0][axis] - 1e3 * at[axis]);
      EXPECT_NEAR(norm(normal), 1.0, 1e-5);
      EXPECT_GT(height, -0.2);
    }
  }
}

// Corners that are one number of single precision are one corner.
TEST(ClosedSurface, StaysClosedInSinglePrecision) {
  const test::TemporaryDirectory directory;
  StlFile file(directory.path() / "small.stl", "", 1.0);
  const Ellipsoid far_away{{1.0, 1.0, 1.0}, {3e-6, 3e-6, 3e-6}};
  const auto surface = surface_of(far_away, divided_icosahedron(0.05));
  file.add(surface);
  file.commit();
  EXPECT_LT(file.triangles(), surface.triangles.size());
  const auto triangles = test::parse_stl(read_text(directory.path() / "small.stl"));
  std::map<std::pair<test::Point, test::Point>, int> balance;
  for (const auto& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++balance[{triangle.corners[k], triangle.corners[(k + 1) % 3]}];
      --balance[{triangle.corners[(k + 1) % 3], triangle.corners[k]}];
    }
  }
  for (const auto& [edge, count] : balance) EXPECT_EQ(count, 0);
}

TEST(ClosedSurface, IsNotLeftHalfWritten) {
  const test::TemporaryDirectory directory;
  {
    StlFile file(directory.path() / "ball.stl", "", 1.0);
    file.add(divided_icosahedron(0.3));
  }
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
  EXPECT_THROW(StlFile(directory.path() / "missing" / "ball.stl", "", 1.0), FileError);
}

}  // namespace
}  // namespace breccia
