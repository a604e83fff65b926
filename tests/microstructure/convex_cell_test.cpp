#include "breccia/microstructure/convex_cell.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include <gmock/gmock.h>

#include "sum.hpp"

namespace breccia {
namespace {

using test::sum;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::SizeIs;

ConvexCell<2> rectangle(double width, double height) {
  return {{0.0, 0.0}, {width, height}, {{{1, 2}, {3, 4}}}};
}

ConvexCell<3> box(const Vector<3>& upper) {
  return {{0.0, 0.0, 0.0}, upper, {{{1, 2}, {3, 4}, {5, 6}}}};
}

/// The regular polygon with this number of sides around the circle of radius 1, cut out of a square.
ConvexCell<2> regular_polygon(int sides) {
  ConvexCell<2> cell({-3.0, -3.0}, {3.0, 3.0}, {{{91, 92}, {93, 94}}});
  for (int side = 0; side < sides; ++side) {
    const double angle = 0.1 + 2.0 * std::numbers::pi * side / sides;
    cell.cut({{std::cos(angle), std::sin(angle)}, 1.0, static_cast<std::uint32_t>(side)});
  }
  cell.trim();
  return cell;
}

/// |x| + |y| + |z| <= 1; four faces meet in each corner.
ConvexCell<3> octahedron() {
  ConvexCell<3> cell({-2.0, -2.0, -2.0}, {2.0, 2.0, 2.0}, {{{91, 92}, {93, 94}, {95, 96}}});
  for (std::uint32_t side = 0; side < 8; ++side) {
    Vector<3> normal;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      normal[axis] = (((side >> axis) & 1U) != 0 ? 1.0 : -1.0) * std::numbers::inv_sqrt3;
    }
    cell.cut({normal, std::numbers::inv_sqrt3, side});
  }
  cell.trim();
  return cell;
}

TEST(ConvexCell, Rectangle) {
  const auto cell = rectangle(3.0, 2.0);
  EXPECT_DOUBLE_EQ(volume(cell), 6.0);
  EXPECT_THAT(face_measures(cell), ElementsAre(2.0, 2.0, 3.0, 3.0));
  const auto of_cell = moments(cell);
  EXPECT_DOUBLE_EQ(of_cell.volume, 6.0);
  EXPECT_DOUBLE_EQ(of_cell.centroid[0], 1.5);
  EXPECT_DOUBLE_EQ(of_cell.centroid[1], 1.0);
  EXPECT_NEAR(of_cell.covariance[0][0], 9.0 / 12.0, 1e-15);
  EXPECT_NEAR(of_cell.covariance[1][1], 4.0 / 12.0, 1e-15);
  EXPECT_NEAR(of_cell.covariance[0][1], 0.0, 1e-15);
  EXPECT_NEAR(aspect_ratio(of_cell), 1.5, 1e-14);
  EXPECT_DOUBLE_EQ(cell.reach(), std::sqrt(13.0));
}

TEST(ConvexCell, Box) {
  const auto cell = box({1.0, 2.0, 4.0});
  EXPECT_DOUBLE_EQ(volume(cell), 8.0);
  EXPECT_THAT(face_measures(cell), ElementsAre(8.0, 8.0, 4.0, 4.0, 2.0, 2.0));
  const auto of_cell = moments(cell);
  EXPECT_NEAR(of_cell.centroid[2], 2.0, 1e-15);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double length = std::array{1.0, 2.0, 4.0}[axis];
    EXPECT_NEAR(of_cell.covariance[axis][axis], length * length / 12.0, 1e-14);
  }
  EXPECT_NEAR(aspect_ratio(of_cell), 4.0, 1e-13);
}

TEST(ConvexCell, AHalfOfABoxIsLeft) {
  auto cell = box({2.0, 2.0, 2.0});
  const double half_diagonal = std::sqrt(0.5);
  EXPECT_TRUE(cell.cut({{half_diagonal, half_diagonal, 0.0}, 2.0 * half_diagonal, 7}));  // x + y <= 2
  cell.trim();
  EXPECT_NEAR(volume(cell), 4.0, 1e-14);
  EXPECT_NEAR(sum(face_measures(cell)), 2.0 + 2.0 + 4.0 + 4.0 + 4.0 * std::numbers::sqrt2, 1e-14);
  EXPECT_NEAR(moments(cell).centroid[0], 2.0 / 3.0, 1e-15);
}

TEST(ConvexCell, PlanesThatTouchCutNothing) {
  auto cell = rectangle(1.0, 1.0);
  const double diagonal = std::sqrt(0.5);
  EXPECT_FALSE(cell.cut({{1.0, 0.0}, 1.0, 7}));                       // the right side
  EXPECT_FALSE(cell.cut({{diagonal, diagonal}, 2.0 * diagonal, 8}));  // through the upper right corner
  EXPECT_FALSE(cell.cut({{1.0, 0.0}, 1.0 - 1e-16, 9}));               // by less than roundoff
  EXPECT_TRUE(cell.cut({{diagonal, diagonal}, 2.0 * diagonal - 0.1, 9}));
  EXPECT_NEAR(volume(cell), 1.0 - 0.01, 1e-15);  // a triangle of height 0.1 and base 0.2
}

TEST(ConvexCell, CutAwayEntirely) {
  auto cell = box({1.0, 1.0, 1.0});
  EXPECT_TRUE(cell.cut({{0.0, 0.0, 1.0}, -0.5, 7}));
  EXPECT_TRUE(cell.is_empty());
  EXPECT_EQ(volume(cell), 0.0);
  EXPECT_EQ(moments(cell).volume, 0.0);
  EXPECT_EQ(aspect_ratio(moments(cell)), 1.0);
  EXPECT_FALSE(cell.cut({{0.0, 0.0, 1.0}, -0.6, 7}));
  EXPECT_TRUE(ConvexCell<2>().is_empty());
  EXPECT_TRUE(rectangle(1.0, 2.0).eroded(0.51).is_empty());
}

TEST(ConvexCell, RegularPolygons) {
  for (const int sides : {3, 6, 17}) {
    const auto cell = regular_polygon(sides);
    const double half_side = std::tan(std::numbers::pi / sides);
    EXPECT_THAT(cell.half_spaces(), SizeIs(sides));
    EXPECT_NEAR(volume(cell), sides * half_side, 1e-13);
    EXPECT_THAT(face_measures(cell), Each(::testing::DoubleNear(2.0 * half_side, 1e-13)));
    EXPECT_NEAR(aspect_ratio(moments(cell)), 1.0, 1e-12);
    EXPECT_NEAR(volume(cell.eroded(0.25)), 0.5625 * sides * half_side, 1e-13);
    EXPECT_TRUE(cell.eroded(1.0001).is_empty());
  }
}

TEST(ConvexCell, CornersInOrder) {
  const auto corners = polygon(regular_polygon(17));
  double twice_area = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& next = corners[(k + 1) % corners.size()];
    twice_area += corners[k][0] * next[1] - corners[k][1] * next[0];
  }
  EXPECT_THAT(corners, SizeIs(17));
  EXPECT_NEAR(twice_area, 2.0 * 17.0 * std::tan(std::numbers::pi / 17.0), 1e-13);
}

TEST(ConvexCell, Octahedron) {
  const auto cell = octahedron();
  EXPECT_THAT(cell.half_spaces(), SizeIs(8));
  EXPECT_NEAR(volume(cell), 4.0 / 3.0, 1e-14);
  EXPECT_THAT(face_measures(cell), Each(::testing::DoubleNear(0.5 * std::sqrt(3.0), 1e-14)));
  EXPECT_NEAR(moments(cell).covariance[1][1], 0.1, 1e-14);
  const auto eroded = cell.eroded(0.5 * std::numbers::inv_sqrt3);
  EXPECT_NEAR(volume(eroded), 4.0 / 24.0, 1e-14);
}

TEST(ConvexCell, AShortEdgeVanishesInErosion) {
  // A trapezium of height 1 whose upper side is 0.2 long: sides at 45 degrees.
  auto cell = rectangle(2.2, 1.0);
  const double root = std::sqrt(0.5);
  cell.cut({{-root, root}, 0.0, 7});        // y <= x
  cell.cut({{root, root}, 2.2 * root, 8});  // y <= 2.2 - x
  cell.trim();
  ASSERT_NEAR(volume(cell), 0.5 * (2.2 + 0.2), 1e-15);
  const double d = 0.3;
  // The slopes meet at the height 1.1. After erosion they meet at 1.1 - d sqrt(2), which is below the upper side at 1 -
  // d.
  const double height = 1.1 - d * std::numbers::sqrt2 - d;
  const auto eroded = cell.eroded(d);
  EXPECT_THAT(eroded.half_spaces(), SizeIs(3));
  EXPECT_NEAR(volume(eroded), height * height, 1e-15);
}

}  // namespace
}  // namespace breccia
