// Tests of the outlines of particles with gaps under a cell.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "discretisation/gaps/plane/outline.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia::gaps {
namespace {

struct Case {
  const char* name;
  Particle particle;
  double layer;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> cases = {
      {"Disc", {Ellipse{{7.0, 7.0}}, Pose({0.3, -0.4}, 0.0)}, 0.0},
      {"DiscWithLayer", {Ellipse{{6.0, 6.0}}, Pose({0.3, -0.4}, 0.0)}, 0.5},
      {"Ellipse", {Ellipse{{9.0, 4.0}}, Pose({0.2, 0.1}, 0.7)}, 0.0},
      {"TallEllipse", {Ellipse{{3.0, 11.0}}, Pose({-0.2, 0.6}, 0.2)}, 0.0},
      {"EllipseWithLayer", {Ellipse{{8.0, 3.0}}, Pose({0.2, 0.1}, 0.7)}, 0.4},
      {"Polygon", {ConvexPolygon({{-3.0, -2.0}, {2.0, -2.5}, {4.0, 1.0}, {0.0, 3.0}}), Pose({0.1, 0.3}, 1.1)}, 0.0},
      {"PolygonWithLayer", {ConvexPolygon({{-3.0, -2.0}, {2.0, -2.5}, {4.0, 1.0}}), Pose({0.1, 0.3}, 2.0)}, 0.7}};
  return cases;
}

class AnyOutline : public testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] const Case& one() const { return cases()[GetParam()]; }
  [[nodiscard]] Outline outline() const { return {one().particle, one().layer, 1.0}; }
  /// Errors of layers around other particles than discs, which are polygons of many corners.
  [[nodiscard]] double tolerance() const { return one().layer > 0.0 && GetParam() > 1 ? 2e-4 : 1e-9; }
};

// The distance is that of signed_distance(), which is exact outside, and has its gradient.
TEST_P(AnyOutline, HasDistancesAndNormals) {
  const auto outline = this->outline();
  for (int i = 0; i < 40; ++i) {
    const Vector<2> point = {7.0 * std::cos(2.4 * i) + 0.01 * i, 7.0 * std::sin(2.4 * i)};
    const double expected = signed_distance(one().particle, point) - one().layer;
    if (expected + one().layer > 0.0) {
      EXPECT_NEAR(outline.distance(point), expected, 1e-9);
    } else {
      EXPECT_LE(outline.distance(point), expected + 1e-9);
    }
    constexpr double step = 1e-5;
    const auto normal = outline.normal(point);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      auto before = point, behind = point;
      before[axis] -= step;
      behind[axis] += step;
      EXPECT_NEAR((outline.distance(behind) - outline.distance(before)) / (2.0 * step), normal[axis], 1e-4);
    }
    EXPECT_NEAR(norm(normal), 1.0, 1e-12);
  }
}

// Inside, the distance is to the nearest point of the outline.
TEST_P(AnyOutline, IsAsFarAsItsNearestPoint) {
  const auto outline = this->outline();
  for (const Vector<2>& point : {Vector<2>{0.3, 0.2}, Vector<2>{1.1, -0.7}, Vector<2>{-0.6, 0.9}}) {
    ASSERT_LT(outline.distance(point), 0.0);
    double nearest = 100.0;
    for (double y = -8.0; y < 8.0; y += 0.002) {
      const auto inside = outline.chord({{0.0, y}, 0});
      if (!inside) continue;
      for (const double x : {inside->begin, inside->end}) nearest = std::min(nearest, norm(point - Vector<2>{x, y}));
    }
    const bool is_exact = one().layer == 0.0 || GetParam() == 1;
    EXPECT_NEAR(outline.distance(point), -nearest, is_exact ? 1e-3 : one().layer) << point[0];
  }
}

TEST_P(AnyOutline, ChordsEndOnIt) {
  const auto outline = this->outline();
  int found = 0;
  for (int i = 0; i < 40; ++i) {
    const GridLine<2> line = {{-3.0, 0.37 * i - 7.0}, 0};
    const GridLine<2> upright = {{0.37 * i - 7.0, 1.0}, 1};
    for (const auto& one_line : {line, upright}) {
      const auto inside = outline.chord(one_line);
      if (!inside) continue;
      ++found;
      EXPECT_LT(inside->begin, inside->end);
      EXPECT_NEAR(outline.distance(one_line.at(inside->begin)), 0.0, tolerance());
      EXPECT_NEAR(outline.distance(one_line.at(inside->end)), 0.0, tolerance());
    }
  }
  EXPECT_GT(found, 20);
}

// The areas in all squares of a grid add up to that of the particle, by Steiner's formula with a layer; one of them is
// found by chords.
TEST_P(AnyOutline, HasItsAreaInSquares) {
  const auto outline = this->outline().moved({0.21, 0.33});
  double sum = 0.0;
  for (int x = -9; x < 9; ++x) {
    for (int y = -9; y < 9; ++y) {
      const Vector<2> corner = {static_cast<double>(x), static_cast<double>(y)};
      const double area = outline.content_of_cell(corner);
      EXPECT_GE(area, 0.0);
      EXPECT_LE(area, 1.0);
      sum += area;
      double by_chords = 0.0;
      constexpr int chords = 400;
      for (int i = 0; i < chords; ++i) {
        const auto inside = outline.chord({{corner[0], corner[1] + (i + 0.5) / chords}, 0});
        if (!inside) continue;
        by_chords += std::max(0.0, std::min(inside->end, 1.0) - std::max(inside->begin, 0.0)) / chords;
      }
      ASSERT_NEAR(area, by_chords, 2e-3) << x << ' ' << y;
    }
  }
  const auto& [name, particle, layer] = one();
  const double exact = area(particle.shape) + perimeter(particle.shape) * layer + std::numbers::pi * layer * layer;
  EXPECT_NEAR(sum / exact, 1.0, 0.1 * tolerance());
}

// A side on the line counts, on either side of the polygon.
TEST(PolygonOutline, HasChordsAlongItsSides) {
  const PolygonOutline square = {{{2.0, 2.0}, {6.0, 2.0}, {6.0, 6.0}, {2.0, 6.0}}};
  for (const double at : {2.0, 3.0, 6.0}) {
    for (const GridLine<2>& line : {GridLine<2>{{1.0, at}, 0}, GridLine<2>{{at, 1.0}, 1}}) {
      const auto inside = chord(square, line);
      ASSERT_TRUE(inside) << at;
      EXPECT_EQ(inside->begin, 1.0);
      EXPECT_EQ(inside->end, 5.0);
    }
  }
  EXPECT_FALSE(chord(square, GridLine<2>{{1.0, 6.5}, 0}));
}

INSTANTIATE_TEST_SUITE_P(Of, AnyOutline, testing::Range(std::size_t{0}, cases().size()),
                         [](const auto& info) { return cases()[info.param].name; });

}  // namespace
}  // namespace breccia::gaps
