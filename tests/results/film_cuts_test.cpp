#include "results/film_cuts.hpp"

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// The area of a polygon, positive where its corners are counter-clockwise.
double area_of(const CellPolygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const auto& [x, y] = polygon.corners[i];
    const auto& [next_x, next_y] = polygon.corners[(i + 1) % polygon.corners.size()];
    twice += x * next_y - next_x * y;
  }
  return 0.5 * twice;
}

/// A tetrahedron between the planes z = 0 and z = 1 that is displaced upwards.
FilmFields<3> tetrahedron(double up) {
  return {.points = {{0.0, 0.0, up}, {1.0, 0.0, up}, {0.0, 1.0, up}, {0.0, 0.0, up + 1.0}},
          .displacement = {},
          .cells = {{.part = FilmPart::grain, .corners = 4}},
          .corners = {0, 1, 2, 3}};
}

// At a height h the triangle of a tetrahedron has the area (1 - h)^2 / 2.
TEST(FilmCuts, OfATetrahedronAreTriangles) {
  for (const double side : {0.5, 1.0, 1.5}) {
    const double height = 0.5 * side;
    const auto cuts = polygons_of(tetrahedron(0.0), side);
    // A box of half the height is cut at 1/4 and, by its image, at 3/4.
    ASSERT_EQ(cuts.size(), side == 0.5 ? 2U : 1U);
    EXPECT_EQ(cuts.front().corners.size(), 3U);
    EXPECT_NEAR(area_of(cuts.front()), 0.5 * (1.0 - height) * (1.0 - height), 1e-15);
  }
}

TEST(FilmCuts, HaveQuadrilateralsInOrder) {
  auto fields = tetrahedron(0.0);
  // Two corners above and two below the plane z = 1/2: a square of half the edges.
  fields.points = {{0.0, 0.0, 0.0}, {1.0, 0.0, 1.0}, {0.0, 1.0, 1.0}, {1.0, 1.0, 0.0}};
  const auto cuts = polygons_of(fields, 1.0);
  ASSERT_EQ(cuts.size(), 1U);
  EXPECT_EQ(cuts.front().corners.size(), 4U);
  EXPECT_NEAR(area_of(cuts.front()), 0.5, 1e-15);
}

TEST(FilmCuts, ShowImagesOfCellsAboveAndBelow) {
  for (const double up : {-2.2, -1.2, -0.2, 0.8}) {
    const auto cuts = polygons_of(tetrahedron(up), 1.0);
    ASSERT_EQ(cuts.size(), 1U) << up;
    EXPECT_NEAR(area_of(cuts.front()), 0.5 * 0.3 * 0.3, 1e-12) << up;
  }
}

TEST(FilmCuts, OfAWedgeAreItsSections) {
  const FilmFields<3> fields = {
      .points = {{0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, {0.0, 1.0, 1.0}, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}},
      .displacement = {},
      .cells = {{.part = FilmPart::film, .corners = 6}},
      .corners = {0, 1, 2, 3, 4, 5}};
  const auto cuts = polygons_of(fields, 1.0);
  ASSERT_EQ(cuts.size(), 1U);
  EXPECT_NEAR(area_of(cuts.front()), 0.5, 1e-15);
}

TEST(FilmCuts, OfThePlaneAreItsCells) {
  const FilmFields<2> fields = {
      .points = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}},
      .displacement = {},
      .cells = {{.part = FilmPart::grain, .corners = 3}, {.part = FilmPart::film, .corners = 4}},
      .corners = {0, 1, 2, 0, 1, 3, 2}};
  const auto polygons = polygons_of(fields, 1.0);
  ASSERT_EQ(polygons.size(), 2U);
  EXPECT_NEAR(area_of(polygons[0]), 0.5, 1e-15);
  EXPECT_NEAR(area_of(polygons[1]), 1.0, 1e-15);
  EXPECT_EQ(polygons[1].cell, 1U);
}

}  // namespace
}  // namespace breccia
