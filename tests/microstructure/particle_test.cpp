#include "breccia/microstructure/particle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace breccia {
namespace {

double uniform(std::mt19937_64& engine, double from, double to) {
  return from + (to - from) * 0x1p-53 * static_cast<double>(engine() >> 11);
}

Shape random_shape(std::mt19937_64& engine) {
  if (engine() % 2 == 0) return Ellipse{{uniform(engine, 0.2, 2.0), uniform(engine, 0.2, 2.0)}};
  // Corners on an ellipse make a convex polygon.
  const int count = 3 + static_cast<int>(engine() % 5);
  const double width = uniform(engine, 0.2, 1.0), height = uniform(engine, 0.2, 1.0);
  std::vector<Vector<2>> corners;
  for (int corner = 0; corner < count; ++corner) {
    const double angle = 2.0 * std::numbers::pi * (corner + uniform(engine, 0.0, 0.8)) / count;
    corners.push_back({width * std::cos(angle), height * std::sin(angle)});
  }
  return ConvexPolygon(corners);
}

Particle random_particle(std::mt19937_64& engine) {
  const Pose pose({uniform(engine, -2.0, 2.0), uniform(engine, -2.0, 2.0)}, uniform(engine, 0.0, 7.0));
  return {random_shape(engine), pose};
}

/// Points on the outline of a particle, `count` of them on an ellipse and on each side of a polygon.
std::vector<Vector<2>> outline(const Particle& particle, int count) {
  std::vector<Vector<2>> points;
  const auto add = [&](double x, double y) {
    const auto seen = particle.pose.from_shape({x, y});
    points.push_back({particle.pose.centre()[0] + seen[0], particle.pose.centre()[1] + seen[1]});
  };
  if (const auto* ellipse = std::get_if<Ellipse>(&particle.shape)) {
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / count;
      add(0.5 * ellipse->axes[0] * std::cos(angle), 0.5 * ellipse->axes[1] * std::sin(angle));
    }
    return points;
  }
  const auto corners = std::get<ConvexPolygon>(particle.shape).corners();
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    const auto& next = corners[(corner + 1) % corners.size()];
    for (int k = 0; k < count; ++k) {
      const double share = static_cast<double>(k) / count;
      add(corners[corner][0] + share * (next[0] - corners[corner][0]),
          corners[corner][1] + share * (next[1] - corners[corner][1]));
    }
  }
  return points;
}

double distance(const Vector<2>& one, const Vector<2>& other) {
  return std::hypot(one[0] - other[0], one[1] - other[1]);
}

TEST(Particle, SignedDistanceIsThatOfTheNearestPlaceOfTheOutline) {
  std::mt19937_64 engine(5);
  for (int trial = 0; trial < 200; ++trial) {
    const auto particle = random_particle(engine);
    const Vector<2> point = {uniform(engine, -3.0, 3.0), uniform(engine, -3.0, 3.0)};
    double nearest = 100.0;
    for (const auto& on : outline(particle, 4000)) nearest = std::min(nearest, distance(on, point));
    const double found = signed_distance(particle, point);
    if (found < 0.0) {
      EXPECT_GE(nearest, -found - 1e-12);
    } else {
      EXPECT_LE(found, nearest + 1e-12);
      EXPECT_NEAR(found, nearest, 2e-5) << trial;
    }
  }
}

TEST(Particle, GapIsTheSmallestDistanceOfTwoOutlines) {
  std::mt19937_64 engine(7);
  int apart = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto one = random_particle(engine), other = random_particle(engine);
    const double found = gap(one.shape, one.pose, other.shape, other.pose).width;
    EXPECT_NEAR(gap(other.shape, other.pose, one.shape, one.pose).width, found, found > 0.0 ? 1e-12 : 1.0);
    double nearest = 100.0;
    for (const auto& point : outline(other, 800)) nearest = std::min(nearest, signed_distance(one, point));
    if (found > 0.0) {
      ++apart;
      EXPECT_LE(found, nearest + 1e-12);
      EXPECT_NEAR(found, nearest, 1e-4) << trial;
    } else {
      const bool holds = signed_distance(one, other.pose.centre()) < 0.0;
      EXPECT_TRUE(nearest < 0.0 || holds || signed_distance(other, one.pose.centre()) < 0.0) << trial;
    }
  }
  EXPECT_GT(apart, 100);
}

TEST(Particle, GapOfDiscsIsThatOfTheirCentres) {
  const Shape one = Ellipse{{2.0, 2.0}}, other = Ellipse{{1.0, 1.0}};
  const auto [width, direction] = gap(one, Pose({0.0, 0.0}, 0.3), other, Pose({3.0, 4.0}, 1.0));
  EXPECT_NEAR(width, 3.5, 1e-14);
  EXPECT_NEAR(direction[0], 0.6, 1e-8);
  EXPECT_NEAR(direction[1], 0.8, 1e-8);
}

TEST(Particle, OverlapIsTheWayThatPartsTwoParticles) {
  const Shape square = ConvexPolygon({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}});
  const auto [width, direction] = gap(square, Pose({0.0, 0.0}, 0.0), square, Pose({0.9, 0.2}, 0.0));
  EXPECT_NEAR(width, -0.1, 1e-12);
  const Pose parted({0.9 - width * direction[0], 0.2 - width * direction[1]}, 0.0);
  EXPECT_NEAR(gap(square, Pose({0.0, 0.0}, 0.0), square, parted).width, 0.0, 1e-12);
}

TEST(Particle, AGapThatIsEnoughIsABound) {
  const Shape ellipse = Ellipse{{4.0, 1.0}};
  const Pose here({0.0, 0.0}, 0.2), there({3.0, 2.0}, 1.1);
  const double exact = gap(ellipse, here, ellipse, there).width;
  const double bound = gap(ellipse, here, ellipse, there, 0.3 * exact).width;
  EXPECT_GE(bound, 0.3 * exact);
  EXPECT_LE(bound, exact);
}

TEST(Particle, ExtentOfATurnedEllipse) {
  const auto reach = extent(Ellipse{{4.0, 2.0}}, Pose({0.0, 0.0}, std::numbers::pi / 4.0));
  for (const auto& along : reach) {
    EXPECT_NEAR(along[0], std::sqrt(2.5), 1e-14);
    EXPECT_NEAR(along[1], std::sqrt(2.5), 1e-14);
  }
}

TEST(Particle, HasADiameterOfEqualArea) {
  EXPECT_DOUBLE_EQ(equivalent_diameter(Ellipse{{4.0, 1.0}}), 2.0);
}

}  // namespace
}  // namespace breccia
