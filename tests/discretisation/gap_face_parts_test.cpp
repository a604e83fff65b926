// Tests of the flux through a face in space whose nodes belong to particles (docs/gaps-in-space.md).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "discretisation/gaps/space/face_parts.hpp"
#include "discretisation/gaps/space/facet_corners.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

/// Changes of owner at places that differ from edge to edge.
ChangesOfOwner changes_between(const std::array<int, 4>& owners) {
  constexpr std::array<double, 4> places = {0.2, 0.7, 0.45, 0.9};
  ChangesOfOwner changes;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t node = 0; node < 4; ++node) {
      const auto edge = edge_from(node, axis);
      if (owners[node] != owners[node ^ (std::size_t{1} << axis)]) changes[edge] = places[edge];
    }
  }
  return changes;
}

class OwnersOfAFace : public testing::TestWithParam<std::array<int, 4>> {};

TEST_P(OwnersOfAFace, LetLinearDisplacementsHaveTheirFlux) {
  const auto flux = flux_through_face(changes_between(GetParam()));
  const double at_origin = 0.3;
  const Vector<2> slope = {-1.1, 0.7};
  double found = 0.0;
  for (std::size_t node = 0; node < 4; ++node) {
    const Vector<2> place = {static_cast<double>(node & 1U), static_cast<double>(node >> 1U)};
    found += flux.of_nodes[node] * (at_origin + dot(slope, place)) + dot(flux.of_slopes[node], slope);
  }
  EXPECT_NEAR(found, at_origin + 0.5 * (slope[0] + slope[1]), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(All, OwnersOfAFace,
                         testing::Values(std::array{0, 0, 0, 0}, std::array{0, 1, 0, 1}, std::array{0, 0, 1, 1},
                                         std::array{0, 1, 1, 1}, std::array{1, 1, 0, 1}, std::array{0, 1, 1, 0},
                                         std::array{0, 1, 2, 2}, std::array{0, 1, 0, 2}, std::array{0, 1, 2, 3}));

TEST(FluxThroughFace, OfOneOwnerIsTheMeanOfItsNodes) {
  const auto flux = flux_through_face({});
  EXPECT_EQ(flux.of_nodes, (std::array{0.25, 0.25, 0.25, 0.25}));
  EXPECT_EQ(flux.of_slopes, (std::array<Vector<2>, 4>{}));
}

TEST(FluxThroughFace, OfAParticleThatMovesIsItsPartOfTheFace) {
  const auto flux = flux_through_face(changes_between({0, 1, 0, 1}));
  EXPECT_NEAR(flux.of_nodes[0] + flux.of_nodes[2], 0.5 * (0.2 + 0.7), 1e-15);
}

/// A plane through the unit cube; what lies on the side of its normal belongs to the second particle.
struct Plane {
  Vector<3> normal;
  double offset;

  [[nodiscard]] double distance(const Vector<3>& point) const { return dot(normal, point) - offset; }
};

Vector<3> node_of_cube(std::size_t node) {
  return {static_cast<double>(node & 1U), static_cast<double>((node >> 1U) & 1U), static_cast<double>(node >> 2U)};
}

/// The place of the plane on the edge from a node of the cube along an axis, if it cuts it.
std::optional<double> change_on_edge(const Plane& plane, std::size_t node, std::size_t axis) {
  const std::size_t step = std::size_t{1} << axis;
  const double lower = plane.distance(node_of_cube(node & ~step)), upper = plane.distance(node_of_cube(node | step));
  if ((lower > 0.0) == (upper > 0.0)) return std::nullopt;
  return lower / (lower - upper);
}

/// A motion v + w x r of the second particle; the first one is at rest.
struct Motion {
  Vector<3> velocity, rotation;

  [[nodiscard]] Vector<3> at(const Vector<3>& r) const {
    const auto& w = rotation;
    return velocity + Vector<3>{w[1] * r[2] - w[2] * r[1], w[2] * r[0] - w[0] * r[2], w[0] * r[1] - w[1] * r[0]};
  }
  [[nodiscard]] double slope(std::size_t component, std::size_t axis) const {
    Vector<3> unit{};
    unit[axis] = 1.0;
    return at(unit)[component] - velocity[component];
  }
};

ChangesInCell changes_in_cube(const Plane& plane) {
  ChangesInCell changes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t node = 0; node < 8; ++node) changes[edge_of_cell(node, axis)] = change_on_edge(plane, node, axis);
  }
  return changes;
}

/// The changes of owner on a face of the cube.
ChangesOfOwner changes_on_face(const ChangesInCell& changes, std::size_t face) {
  ChangesOfOwner on_face;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t node = 0; node < 4; ++node) {
      on_face[edge_from(node, axis)] = changes[edge_of_cell(node_of_face(face, node), axis_of_face(face, axis))];
    }
  }
  return on_face;
}

/// What flows out of the cube through its faces.
double volume_change(const Plane& plane, const Motion& motion) {
  const auto changes = changes_in_cube(plane);
  double out = 0.0;
  for (std::size_t face = 0; face < 6; ++face) {
    const auto flux = flux_through_face(changes_on_face(changes, face));
    const std::size_t normal = face / 2;
    for (std::size_t node = 0; node < 4; ++node) {
      const auto place = node_of_cube(node_of_face(face, node));
      if (!(plane.distance(place) > 0.0)) continue;
      const double through = flux.of_nodes[node] * motion.at(place)[normal] +
                             flux.of_slopes[node][0] * motion.slope(normal, axis_of_face(face, 0)) +
                             flux.of_slopes[node][1] * motion.slope(normal, axis_of_face(face, 1));
      out += face % 2 == 1 ? through : -through;
    }
  }
  return out;
}

/// The area of a polygon and its centroid.
std::pair<double, Vector<3>> area_and_centroid(const std::vector<Vector<3>>& corners) {
  const auto& origin = corners.front();
  double area = 0.0;
  Vector<3> moment{};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const auto a = corners[k] - origin, b = corners[k + 1] - origin;
    const double part = 0.5 * std::sqrt(std::max(dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b), 0.0));
    area += part;
    moment += part / 3.0 * (3.0 * origin + a + b);
  }
  return {area, moment / area};
}

/// Planes that cut the cube in three, four, five and six edges.
std::vector<Plane> planes() {
  std::vector<Plane> found;
  for (const Vector<3>& direction :
       {Vector<3>{0.0, 0.0, 1.0}, Vector<3>{0.2, 0.1, 1.0}, Vector<3>{1.0, -0.8, 0.3}, Vector<3>{1.0, 0.9, 0.8}}) {
    const auto normal = direction / norm(direction);
    for (const double along : {-0.3, -0.05, 0.1, 0.35}) {
      found.push_back({normal, dot(normal, Vector<3>{0.5, 0.5, 0.5}) + along});
    }
  }
  found.push_back({{2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0}, 0.2});
  return found;
}

TEST(CornersOfFacet, LieOnThePlaneAndOnTheirFaces) {
  std::size_t most = 0, fewest = 12;
  for (const auto& plane : planes()) {
    const auto facet = corners_of_facet(changes_in_cube(plane));
    ASSERT_TRUE(facet);
    const auto& [corners, faces] = *facet;
    ASSERT_EQ(corners.size(), faces.size());
    most = std::max(most, corners.size());
    fewest = std::min(fewest, corners.size());
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto place = static_cast<double>(faces[k] % 2);
      EXPECT_NEAR(plane.distance(corners[k]), 0.0, 1e-15);
      EXPECT_EQ(corners[k][faces[k] / 2], place);
      EXPECT_EQ(corners[(k + 1) % corners.size()][faces[k] / 2], place);
    }
  }
  EXPECT_EQ(fewest, 3U);
  EXPECT_EQ(most, 6U);
}

TEST(CornersOfFacet, AreThoseOfASquareBetweenTwoLayersOfNodes) {
  const auto facet = corners_of_facet(changes_in_cube({{0.0, 0.0, 1.0}, 0.3}));
  ASSERT_TRUE(facet);
  EXPECT_EQ(facet->corners.size(), 4U);
  const auto [area, centroid] = area_and_centroid(facet->corners);
  EXPECT_NEAR(area, 1.0, 1e-15);
  EXPECT_NEAR(norm(centroid - Vector<3>{0.5, 0.5, 0.3}), 0.0, 1e-15);
}

TEST(CornersOfFacet, AreNoneInACellOfOneOwner) {
  EXPECT_FALSE(corners_of_facet({}));
}

TEST(CornersOfFacet, AreNoneWhereTheyAreTwoPolygons) {
  // Nodes 0 and 7, in opposite corners, belong to one particle, all others to another one.
  ChangesInCell changes;
  for (const std::size_t node : {std::size_t{0}, std::size_t{7}}) {
    for (std::size_t axis = 0; axis < 3; ++axis) changes[edge_of_cell(node, axis)] = 0.4;
  }
  EXPECT_FALSE(corners_of_facet(changes));
}

TEST(CornersOfFacet, AreNoneWhereOwnersAlternateAroundAFace) {
  // Nodes 0 and 3, across the diagonal of the lower face along the third axis.
  ChangesInCell changes;
  for (const std::size_t node : {std::size_t{0}, std::size_t{3}}) {
    for (std::size_t axis = 0; axis < 3; ++axis) changes[edge_of_cell(node, axis)] = 0.4;
  }
  EXPECT_FALSE(corners_of_facet(changes));
}

TEST(FluxThroughFaces, OfACubeIsThatThroughTheGap) {
  const Motion motion = {{0.3, -0.7, 0.4}, {0.9, 0.2, -0.5}};
  for (const auto& plane : planes()) {
    const auto [area, centroid] = area_and_centroid(corners_of_facet(changes_in_cube(plane))->corners);
    EXPECT_NEAR(volume_change(plane, motion), area * dot(plane.normal, motion.at(centroid)), 1e-13);
  }
}

TEST(FluxThroughFaces, OfACubeVanishesForParticlesThatSlideOrTwist) {
  for (const auto& plane : planes()) {
    const auto& n = plane.normal;
    const Vector<3> along = {n[1] - n[2], n[2] - n[0], n[0] - n[1]};
    EXPECT_NEAR(volume_change(plane, {along, {}}), 0.0, 1e-14);
    EXPECT_NEAR(volume_change(plane, {{}, n}), 0.0, 1e-14);
  }
}

}  // namespace
}  // namespace breccia::gaps
