#include "microstructure/disc_overlap.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace breccia {
namespace {

using std::numbers::pi;
const Disc unit_disc = {{0.0, 0.0}, 2.0};

TEST(OverlapArea, OfRectanglesThatHoldTheDiscItsHalfAndItsQuarter) {
  EXPECT_NEAR(overlap_area(unit_disc, {-1.0, -1.0}, {1.0, 1.0}), pi, 1e-15);
  EXPECT_NEAR(overlap_area(unit_disc, {-3.0, -2.0}, {5.0, 7.0}), pi, 1e-15);
  EXPECT_NEAR(overlap_area(unit_disc, {0.0, -2.0}, {2.0, 2.0}), pi / 2.0, 1e-15);
  EXPECT_NEAR(overlap_area(unit_disc, {-2.0, -2.0}, {0.0, 0.0}), pi / 4.0, 1e-15);
}

TEST(OverlapArea, OfRectanglesInsideAndOutside) {
  EXPECT_NEAR(overlap_area(unit_disc, {-0.5, 0.1}, {0.3, 0.4}), 0.24, 1e-15);
  EXPECT_EQ(overlap_area(unit_disc, {1.0, -1.0}, {2.0, 1.0}), 0.0);
  EXPECT_NEAR(overlap_area(unit_disc, {0.8, 0.8}, {2.0, 1.0}), 0.0, 1e-15);
}

// The area that a chord at the distance d from the centre cuts off is acos d - d sqrt(1 - d^2).
TEST(OverlapArea, OfASegment) {
  for (const double d : {-0.9, -0.3, 0.2, 0.75}) {
    const double segment = std::acos(d) - d * std::sqrt(1.0 - d * d);
    EXPECT_NEAR(overlap_area(unit_disc, {d, -2.0}, {2.0, 2.0}), segment, 1e-14);
    EXPECT_NEAR(overlap_area(unit_disc, {-2.0, -2.0}, {2.0, -d}), segment, 1e-14);
  }
}

TEST(OverlapArea, OfTheCellsOfAGridIsThatOfTheDisc) {
  const Disc disc = {{0.37, 0.61}, 0.53};
  for (const int cells : {3, 17, 100}) {
    const double h = 1.0 / cells;
    double sum = 0.0;
    for (int row = 0; row < cells; ++row) {
      for (int column = 0; column < cells; ++column) {
        const double area = overlap_area(disc, {column * h, row * h}, {(column + 1) * h, (row + 1) * h});
        EXPECT_GE(area, -1e-15);
        EXPECT_LE(area, h * h * (1.0 + 1e-10));
        sum += area;
      }
    }
    EXPECT_NEAR(sum, pi / 4.0 * 0.53 * 0.53, 1e-13);
  }
}

// The test counts the points of a fine lattice inside of both.
TEST(OverlapArea, AgreesWithPointsThatAreCounted) {
  const Disc disc = {{0.2, 0.1}, 1.3};
  const Vector<2> lower = {-0.31, 0.17}, upper = {0.42, 0.93};
  constexpr int points = 2000;
  int inside = 0;
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < points; ++j) {
      const double x = lower[0] + (i + 0.5) / points * (upper[0] - lower[0]);
      const double y = lower[1] + (j + 0.5) / points * (upper[1] - lower[1]);
      inside += disc.contains({x, y}) ? 1 : 0;
    }
  }
  const double counted = (upper[0] - lower[0]) * (upper[1] - lower[1]) * inside / points / points;
  EXPECT_NEAR(overlap_area(disc, lower, upper), counted, 1e-5);
}

}  // namespace
}  // namespace breccia
