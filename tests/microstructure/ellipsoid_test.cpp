#include "breccia/microstructure/ellipsoid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "breccia/microstructure/index.hpp"

#include "microstructure/vector_algebra.hpp"
#include "random_ellipsoids.hpp"

namespace breccia {
namespace {

using test::random_direction;
using test::random_ellipsoid;
using test::uniform_between;

using std::numbers::pi;
constexpr AxisDirections cyclic = {{{0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}};

Vector<3> support(const Ellipsoid& ellipsoid, const Vector<3>& direction) {
  Vector<3> point{};
  double height = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double half = 0.5 * ellipsoid.axes[axis], along = dot(ellipsoid.directions[axis], direction);
    point += half * half * along * ellipsoid.directions[axis];
    height += half * half * along * along;
  }
  return ellipsoid.centre + 1.0 / std::sqrt(height) * point;
}

TEST(Ellipsoid, HasItsVolumeAndSurface) {
  const Ellipsoid sphere = {{0.0, 0.0, 0.0}, {2.0, 2.0, 2.0}};
  EXPECT_DOUBLE_EQ(volume(sphere), 4.0 / 3.0 * pi);
  EXPECT_DOUBLE_EQ(surface(sphere), 4.0 * pi);
  // 2 pi a^2 (1 + (c / (a e)) asin e) for c > a, with e^2 = 1 - a^2 / c^2.
  const double e = std::sqrt(3.0) / 2.0;
  EXPECT_NEAR(surface({{}, {4.0, 2.0, 2.0}}), 2.0 * pi * (1.0 + 2.0 / e * std::asin(e)), 3e-11);
  // 2 pi a^2 (1 + (1 - e^2) / e atanh e) for c < a, with e^2 = 1 - c^2 / a^2.
  EXPECT_NEAR(surface({{}, {4.0, 2.0, 4.0}}), 8.0 * pi * (1.0 + 0.25 / e * std::atanh(e)), 3e-11);
  EXPECT_NEAR(surface({{}, {4.0, 2.0, 6.0}}), 48.882146302582059675, 5e-11);
  // Nearly a sphere: 4 pi (1 + 2 d / 3) for one half axis of 1 + d.
  EXPECT_NEAR(surface({{}, {2.0, 2.0 + 2e-9, 2.0}}), 4.0 * pi * (1.0 + 2e-9 / 3.0), 1e-11);
  EXPECT_DOUBLE_EQ(volume({{}, {4.0, 2.0, 6.0}}), 8.0 * pi);
  EXPECT_EQ(circumradius({{}, {4.0, 2.0, 6.0}}), 3.0);
}

TEST(Ellipsoid, IsTurned) {
  // A third of a turn around the diagonal takes x to y to z.
  const auto directions = turned({1.0, 1.0, 1.0, 1.0});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t row = 0; row < 3; ++row) EXPECT_NEAR(directions[axis][row], cyclic[axis][row], 1e-15);
  }
  const Ellipsoid along_y = {{1.0, 0.0, 0.0}, {4.0, 2.0, 1.0}, cyclic};
  EXPECT_EQ(extent(along_y), (Vector<3>{0.5, 2.0, 1.0}));
  EXPECT_TRUE(along_y.contains({1.0, 1.99, 0.0}));
  EXPECT_FALSE(along_y.contains({1.0, 0.0, 1.01}));
  EXPECT_TRUE(along_y.contains({1.5, 0.0, 0.0}));
}

TEST(Ellipsoid, DistancesOfASphereAreExact) {
  const Ellipsoid sphere = {{1.0, 2.0, 3.0}, {2.0, 2.0, 2.0}};
  EXPECT_NEAR(signed_distance(sphere, {1.0, 2.0, 6.0}), 2.0, 1e-15);
  EXPECT_NEAR(signed_distance(sphere, {1.0, 2.3, 3.4}), -0.5, 1e-15);
  EXPECT_NEAR(signed_distance(sphere, {1.0, 2.0, 3.0}), -1.0, 1e-15);
  EXPECT_NEAR(gap(sphere, {{4.0, 6.0, 3.0}, {3.0, 3.0, 3.0}}), 2.5, 1e-14);
  EXPECT_NEAR(gap(sphere, {{1.0, 2.0, 4.0}, {1.0, 1.0, 1.0}}), -0.5, 1e-14);
  EXPECT_NEAR(gap(sphere, sphere), -2.0, 1e-14);
}

// Along the normal at a point of the surface the distance is that from this point: everywhere outside, and inside up to
// the smallest radius of curvature.
TEST(Ellipsoid, DistancesAlongNormalsAreExact) {
  std::mt19937_64 engine(5);
  for (int count = 0; count < 500; ++count) {
    const auto ellipsoid = random_ellipsoid(engine);
    const auto normal = random_direction(engine);
    const auto point = support(ellipsoid, normal);
    const auto [shortest, longest] = std::ranges::minmax(ellipsoid.axes);
    for (const double distance : {0.0, 1e-6, 0.1, 3.0, -0.9 * 0.5 * shortest * shortest / longest}) {
      EXPECT_NEAR(signed_distance(ellipsoid, point + distance * normal), distance, 1e-13);
    }
  }
}

TEST(Ellipsoid, DistancesOnPlanesOfSymmetry) {
  const Ellipsoid ellipsoid = {{0.0, 0.0, 0.0}, {6.0, 4.0, 2.0}};
  EXPECT_NEAR(signed_distance(ellipsoid, {0.0, 0.0, 0.0}), -1.0, 1e-15);
  // The nearest points to (x, 0, 0) are above and below, where x of the surface is x / (1 - 1/9).
  EXPECT_NEAR(signed_distance(ellipsoid, {0.8, 0.0, 0.0}), -std::hypot(0.1, std::sqrt(1.0 - 0.09)), 1e-14);
  EXPECT_NEAR(signed_distance(ellipsoid, {2.9, 0.0, 0.0}), -0.1, 1e-14);
  EXPECT_NEAR(signed_distance(ellipsoid, {0.0, 0.0, 1e-17}), -1.0, 1e-15);
  EXPECT_NEAR(signed_distance(ellipsoid, {1e-17, 5.0, 0.0}), 3.0, 1e-15);
}

// A gap is tested against both bounds: no direction separates the ellipsoids farther, and no two points are nearer.
TEST(Ellipsoid, GapsAreBetweenTheirBounds) {
  std::mt19937_64 engine(11);
  int apart = 0;
  for (int count = 0; count < 300; ++count) {
    const auto one = random_ellipsoid(engine), other = random_ellipsoid(engine);
    const double found = gap(one, other);
    EXPECT_NEAR(found, gap(other, one), 1e-13);
    for (int trial = 0; trial < 50; ++trial) {
      const auto direction = random_direction(engine);
      const Vector<3> back = {-direction[0], -direction[1], -direction[2]};
      const double along = dot(direction, support(other, back) - support(one, direction));
      if (found > 0.0) {
        EXPECT_LE(along, found + 1e-13);
      } else {
        EXPECT_LE(along, 1e-13);  // no direction separates particles that overlap
      }
    }
    if (found <= 0.0) continue;
    ++apart;
    // No point of the other ellipsoid is nearer than the gap.
    double nearest = std::numeric_limits<double>::infinity();
    for (int trial = 0; trial < 200; ++trial) {
      nearest = std::min(nearest, signed_distance(one, support(other, random_direction(engine))));
    }
    EXPECT_GE(nearest, found - 1e-13);
  }
  EXPECT_GT(apart, 50);
}

// An ellipsoid that touches another one along a common normal, moved away by a known distance.
TEST(Ellipsoid, GapsAlongACommonNormalAreExact) {
  std::mt19937_64 engine(17);
  for (int count = 0; count < 300; ++count) {
    const auto one = random_ellipsoid(engine);
    auto other = random_ellipsoid(engine);
    const auto normal = random_direction(engine);
    const Vector<3> back = {-normal[0], -normal[1], -normal[2]};
    const double width = uniform_between(engine, 0.0, 1.0) * (count % 3 == 0 ? 1e-6 : 1.0);
    const auto wanted = support(one, normal) + width * normal;
    other.centre += wanted - support(other, back);
    EXPECT_NEAR(gap(one, other), width, 1e-12);
  }
}

TEST(Ellipsoid, AnglesTurnItAsTheyShould) {
  constexpr double right = 0.5 * std::numbers::pi;
  const auto up = turned(Turn{0.3, right, 0.0});
  EXPECT_NEAR(up[0][2], 1.0, 1e-15);
  const auto along_y = turned(Turn{right, 0.0, right});
  EXPECT_NEAR(along_y[0][1], 1.0, 1e-15);
  EXPECT_NEAR(along_y[1][2], 1.0, 1e-15) << "the second axis was along -x before the roll";
  EXPECT_NEAR(along_y[2][0], 1.0, 1e-15);
}

TEST(Ellipsoid, AnglesAreFoundAgain) {
  std::mt19937_64 engine(23);
  for (int count = 0; count < 100; ++count) {
    auto one = random_ellipsoid(engine).directions;
    if (count == 0) one = turned(Turn{0.0, 0.5 * std::numbers::pi, 0.4});
    const auto again = turned(turn_of(one));
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(norm(again[axis] - one[axis]), 0.0, 1e-14);
  }
}

TEST(Ellipsoid, MeanWidthsAreThoseOfTheirHalfWidths) {
  EXPECT_NEAR(mean_width({{}, {2.0, 2.0, 2.0}}), 2.0, 1e-14);
  // A disc without thickness: the mean of |sin| over all directions is pi / 4.
  EXPECT_NEAR(mean_width({{}, {2.0, 2.0, 1e-9}}), 0.5 * std::numbers::pi, 1e-8);
  // A needle: the mean of |cos| is 1/2.
  EXPECT_NEAR(mean_width({{}, {2.0, 1e-6, 1e-6}}), 1.0, 1e-5);
}

TEST(Ellipsoid, CoatingsHaveTheVolumeOfTheirPlaces) {
  const double thickness = 0.3;
  EXPECT_NEAR(coating_volume({{}, {2.0, 2.0, 2.0}}, thickness), std::numbers::pi / 6.0 * (2.6 * 2.6 * 2.6 - 8.0),
              1e-13);
  // The volume is counted on a lattice of points in the octant of positive coordinates.
  const Ellipsoid ellipsoid = {{}, {2.0, 1.2, 0.8}};
  constexpr int along = 60;
  constexpr double step = 1.4 / along;
  int inside = 0;
  for_each_index(Index<3>{}, Index<3>{along, along, along}, [&](const Index<3>& index) {
    const double distance =
        signed_distance(ellipsoid, {(index[0] + 0.5) * step, (index[1] + 0.5) * step, (index[2] + 0.5) * step});
    if (distance > 0.0 && distance <= thickness) ++inside;
  });
  EXPECT_NEAR(8.0 * inside * step * step * step / coating_volume(ellipsoid, thickness), 1.0, 2e-3);
}

}  // namespace
}  // namespace breccia
