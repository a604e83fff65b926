// Tests of the flux through a face in space whose nodes belong to particles (docs/gaps-in-space.md).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "discretisation/gaps/face_parts.hpp"
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

/// What flows out of the cube through its faces.
double volume_change(const Plane& plane, const Motion& motion) {
  double out = 0.0;
  for (std::size_t normal = 0; normal < 3; ++normal) {
    const std::array<std::size_t, 2> axes = {normal == 0 ? std::size_t{1} : 0, normal == 2 ? std::size_t{1} : 2};
    for (std::size_t side = 0; side < 2; ++side) {
      const auto node_of = [&](std::size_t node) {
        return (side << normal) | ((node & 1U) << axes[0]) | ((node >> 1U) << axes[1]);
      };
      ChangesOfOwner changes;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        for (std::size_t node = 0; node < 4; ++node) {
          changes[edge_from(node, axis)] = change_on_edge(plane, node_of(node), axes[axis]);
        }
      }
      const auto flux = flux_through_face(changes);
      for (std::size_t node = 0; node < 4; ++node) {
        const auto place = node_of_cube(node_of(node));
        if (!(plane.distance(place) > 0.0)) continue;
        const double through = flux.of_nodes[node] * motion.at(place)[normal] +
                               flux.of_slopes[node][0] * motion.slope(normal, axes[0]) +
                               flux.of_slopes[node][1] * motion.slope(normal, axes[1]);
        out += side == 1 ? through : -through;
      }
    }
  }
  return out;
}

/// The area of the polygon in which the plane cuts the cube, and its centroid.
std::pair<double, Vector<3>> cut(const Plane& plane) {
  std::vector<Vector<3>> corners;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t node = 0; node < 8; ++node) {
      const bool is_lower = ((node >> axis) & 1U) == 0;
      if (const auto place = change_on_edge(plane, node, axis); is_lower && place) {
        corners.push_back(node_of_cube(node));
        corners.back()[axis] = *place;
      }
    }
  }
  Vector<3> middle{};
  for (const auto& corner : corners) middle += corner / static_cast<double>(corners.size());
  const auto first = corners.front() - middle;
  const auto& n = plane.normal;
  const Vector<3> second = {n[1] * first[2] - n[2] * first[1], n[2] * first[0] - n[0] * first[2],
                            n[0] * first[1] - n[1] * first[0]};
  std::ranges::sort(corners, {}, [&](const Vector<3>& corner) {
    return std::atan2(dot(corner - middle, second), dot(corner - middle, first));
  });
  double area = 0.0;
  Vector<3> moment{};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto a = corners[k] - middle, b = corners[(k + 1) % corners.size()] - middle;
    const double part = 0.5 * std::sqrt(std::max(dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b), 0.0));
    area += part;
    moment += part / 3.0 * (3.0 * middle + a + b);
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
  return found;
}

TEST(FluxThroughFaces, OfACubeIsThatThroughTheGap) {
  const Motion motion = {{0.3, -0.7, 0.4}, {0.9, 0.2, -0.5}};
  for (const auto& plane : planes()) {
    const auto [area, centroid] = cut(plane);
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
