#include "microstructure/sphere_overlap.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "breccia/microstructure/index.hpp"

namespace breccia {
namespace {

using std::numbers::pi;
const Sphere unit_sphere = {{0.0, 0.0, 0.0}, 2.0};

TEST(OverlapVolume, OfBoxesThatHoldTheSphereAndPartsOfIt) {
  const double whole = 4.0 / 3.0 * pi;
  EXPECT_NEAR(overlap_volume(unit_sphere, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}), whole, 4e-15);
  EXPECT_NEAR(overlap_volume(unit_sphere, {-3.0, -2.0, -1.5}, {5.0, 7.0, 4.0}), whole, 4e-15);
  EXPECT_NEAR(overlap_volume(unit_sphere, {-2.0, 0.0, -2.0}, {2.0, 2.0, 2.0}), whole / 2.0, 4e-15);
  EXPECT_NEAR(overlap_volume(unit_sphere, {-2.0, 0.0, -2.0}, {2.0, 2.0, 0.0}), whole / 4.0, 4e-15);
  EXPECT_NEAR(overlap_volume(unit_sphere, {-2.0, 0.0, -2.0}, {0.0, 2.0, 0.0}), whole / 8.0, 4e-15);
}

TEST(OverlapVolume, OfBoxesInsideAndOutsideIsExact) {
  EXPECT_EQ(overlap_volume(unit_sphere, {-0.5, 0.0, 0.25}, {0.25, 0.5, 0.5}), 0.75 * 0.5 * 0.25);
  EXPECT_EQ(overlap_volume(unit_sphere, {1.0, -1.0, -1.0}, {2.0, 1.0, 1.0}), 0.0);
  EXPECT_EQ(overlap_volume(unit_sphere, {0.6, 0.6, 0.6}, {2.0, 1.0, 3.0}), 0.0);
}

// A cap of height c has the volume pi c^2 (3 - c) / 3.
TEST(OverlapVolume, OfACap) {
  for (const double height : {0.01, 0.1, 0.7, 1.3}) {
    const double cap = pi * height * height * (3.0 - height) / 3.0;
    EXPECT_NEAR(overlap_volume(unit_sphere, {1.0 - height, -2.0, -2.0}, {2.0, 2.0, 2.0}), cap, 4e-15);
    EXPECT_NEAR(overlap_volume(unit_sphere, {-2.0, -2.0, -2.0}, {2.0, 2.0, height - 1.0}), cap, 4e-15);
  }
}

// Integrals of exact areas of discs in rectangles over the third axis, by adaptive quadrature with 25 digits.
TEST(OverlapVolume, OfBoxesThatCutEdgesAndCorners) {
  EXPECT_NEAR(overlap_volume(unit_sphere, {0.5, 0.5, 0.5}, {2.0, 2.0, 2.0}), 0.0019006861911049853, 1e-15);
  EXPECT_NEAR(overlap_volume(unit_sphere, {0.1, -0.3, 0.2}, {0.7, 0.8, 0.9}), 0.3785617059798451, 1e-15);
  EXPECT_NEAR(overlap_volume(unit_sphere, {-2.0, 0.3, 0.4}, {2.0, 2.0, 2.0}), 0.22496590075237338, 1e-15);
  EXPECT_NEAR(overlap_volume(unit_sphere, {0.57, 0.57, 0.57}, {0.6, 0.6, 0.6}), 1.7701827584927838e-6, 1e-15);
  EXPECT_NEAR(overlap_volume(unit_sphere, {-0.9, -0.8, -0.7}, {0.6, 0.7, 0.95}), 3.0938865355738692, 4e-15);
  EXPECT_NEAR(overlap_volume(unit_sphere, {0.99, -0.1, -0.1}, {1.19, 0.1, 0.1}), 0.00026635383640975456, 1e-15);
}

TEST(OverlapVolume, OfTheCellsOfAGridIsThatOfTheSphere) {
  const Sphere sphere = {{0.37, 0.61, 0.52}, 0.53};
  for (const int cells : {3, 17, 64}) {
    const double h = 1.0 / cells;
    double sum = 0.0;
    for_each_index(Index<3>{0, 0, 0}, Index<3>{cells, cells, cells}, [&](const Index<3>& cell) {
      const Vector<3> lower = {cell[0] * h, cell[1] * h, cell[2] * h};
      const double volume = overlap_volume(sphere, lower, {lower[0] + h, lower[1] + h, lower[2] + h});
      EXPECT_GE(volume, 0.0);
      EXPECT_LE(volume, h * h * h * (1.0 + 1e-12));
      sum += volume;
    });
    EXPECT_NEAR(sum, ball_volume<3>(0.53), 1e-12);
  }
}

}  // namespace
}  // namespace breccia
