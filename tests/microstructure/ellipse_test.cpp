#include "breccia/microstructure/ellipse.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace breccia {
namespace {

TEST(Ellipse, AreaAndPerimeter) {
  const Ellipse ellipse = {{3.0, 2.0}};
  EXPECT_DOUBLE_EQ(area(ellipse), 1.5 * std::numbers::pi);
  // With half axes of 1.5 and 1 the perimeter is 4 a E(sqrt(5)/3), from tables of the complete elliptic integral.
  EXPECT_NEAR(perimeter(ellipse), 7.932719794645294, 1e-12);
  EXPECT_NEAR(perimeter({{2.0, 3.0}}), 7.932719794645294, 1e-12);
  EXPECT_DOUBLE_EQ(perimeter({{2.0, 2.0}}), 2.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(circumradius(ellipse), 1.5);
}

TEST(Ellipse, ContainsThePlacesInsideAndOnIt) {
  const Ellipse ellipse = {{4.0, 2.0}};
  EXPECT_TRUE(ellipse.contains({2.0, 0.0}));
  EXPECT_TRUE(ellipse.contains({0.0, -1.0}));
  EXPECT_FALSE(ellipse.contains({2.0001, 0.0}));
  EXPECT_FALSE(ellipse.contains({1.5, 0.7}));
  EXPECT_TRUE(ellipse.contains({1.5, 0.66}));
}

TEST(Ellipse, NoPlaceIsNearerToTheOutlineThanItsDepth) {
  const Ellipse ellipse = {{4.0, 1.0}};
  for (const double x : {0.0, 0.5, 1.3, 1.9}) {
    for (const double y : {0.0, 0.1, 0.15}) {
      if (!ellipse.contains({x, y})) continue;
      double nearest = 10.0;
      for (int k = 0; k < 20000; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 20000;
        nearest = std::min(nearest, std::hypot(2.0 * std::cos(angle) - x, 0.5 * std::sin(angle) - y));
      }
      EXPECT_LE(ellipse.depth({x, y}), nearest);
      EXPECT_GT(ellipse.depth({x, y}), 0.0);
    }
  }
  EXPECT_DOUBLE_EQ(ellipse.depth({0.0, 0.0}), 0.5);
}

TEST(Ellipse, TheOutlineTouchesThePlanesOfItsSupport) {
  const Ellipse ellipse = {{3.0, 1.0}};
  for (int k = 0; k < 12; ++k) {
    const double angle = std::numbers::pi / 6.0 * k;
    const Vector<2> direction = {std::cos(angle), std::sin(angle)};
    const auto [point, radius] = ellipse.support(direction);
    EXPECT_NEAR(std::hypot(point[0] / 1.5, point[1] / 0.5), 1.0, 1e-14);
    for (int other = 0; other < 100; ++other) {
      const double at = 2.0 * std::numbers::pi * other / 100;
      EXPECT_LE(1.5 * std::cos(at) * direction[0] + 0.5 * std::sin(at) * direction[1],
                point[0] * direction[0] + point[1] * direction[1] + 1e-14);
    }
  }
  EXPECT_DOUBLE_EQ(ellipse.support({1.0, 0.0}).radius_of_curvature, 0.25 / 1.5);
  EXPECT_DOUBLE_EQ(ellipse.support({0.0, 1.0}).radius_of_curvature, 2.25 / 0.5);
}

}  // namespace
}  // namespace breccia
