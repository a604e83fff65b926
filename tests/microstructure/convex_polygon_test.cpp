#include "breccia/microstructure/convex_polygon.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>

#include "breccia/error.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;
using Corners = std::vector<Vector<2>>;

TEST(ConvexPolygon, IsMovedToItsCentroid) {
  const ConvexPolygon triangle({{10.0, 10.0}, {10.0, 16.0}, {13.0, 10.0}});  // clockwise
  ASSERT_EQ(triangle.corners().size(), 3U);
  EXPECT_DOUBLE_EQ(area(triangle), 9.0);
  EXPECT_DOUBLE_EQ(perimeter(triangle), 9.0 + std::sqrt(45.0));
  EXPECT_NEAR(centroid(triangle.corners())[0], 0.0, 1e-15);
  EXPECT_NEAR(centroid(triangle.corners())[1], 0.0, 1e-15);
  EXPECT_NEAR(circumradius(triangle), std::hypot(1.0, 4.0), 1e-14);
  EXPECT_DOUBLE_EQ(area(triangle.scaled(2.0)), 36.0);
}

TEST(ConvexPolygon, DepthIsTheDistanceFromTheNearestSide) {
  const ConvexPolygon square({{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}});
  EXPECT_DOUBLE_EQ(square.depth({0.25, 0.5}), 0.5);
  EXPECT_DOUBLE_EQ(square.depth({0.0, 0.0}), 1.0);
  EXPECT_TRUE(square.contains({1.0, 0.3}));
  EXPECT_FALSE(square.contains({1.01, 0.3}));
}

TEST(ConvexPolygon, RefusesWhatIsNone) {
  expect_error<InputError>([] { ConvexPolygon(Corners{{0.0, 0.0}, {1.0, 0.0}}); }, "three corners");
  expect_error<InputError>(
      [] {
        ConvexPolygon(Corners{{0.0, 0.0}, {2.0, 0.0}, {0.5, 0.5}, {0.0, 2.0}});
      },
      "corner 3", "points inwards");
  expect_error<InputError>([] { ConvexPolygon(Corners{{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}}); }, "on a line");
  expect_error<InputError>(
      [] {
        ConvexPolygon(Corners{{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}});
      },
      "corner 2", "different places");
  expect_error<InputError>(
      [] {
        ConvexPolygon(Corners{{0.0, 0.0}, {1.0, 0.0}, {0.0, std::numeric_limits<double>::quiet_NaN()}});
      },
      "finite");
}

TEST(ConvexPolygon, RefusesAStarWhoseCornersAllTurnOneWay) {
  Corners star;
  for (int k = 0; k < 5; ++k) {
    const double angle = 4.0 * std::numbers::pi / 5.0 * k;
    star.push_back({std::cos(angle), std::sin(angle)});
  }
  expect_error<InputError>([&] { static_cast<void>(ConvexPolygon(star)); }, "sides cross");
}

TEST(ConvexPolygon, TakesACornerOnAStraightSide) {
  const ConvexPolygon square({{0.0, 0.0}, {0.3, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}});
  EXPECT_DOUBLE_EQ(area(square), 1.0);
}

}  // namespace
}  // namespace breccia
