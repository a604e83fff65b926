#include "homogenisation/box/filler_on_sides.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace breccia {
namespace {

const Material soft{.name = "soft", .density = 1.0, .bulk = PronySeries(4.0), .shear = PronySeries(1.0)};
const Material hard{.name = "hard", .density = 1.0, .bulk = PronySeries(4.0), .shear = PronySeries(2.0)};

template <int dim, class Particle>
Stage box_of(std::vector<Particle> particles, Walls walls) {
  return {.name = "A",
          .matrix = soft,
          .side = 2.0,
          .cells = 10,
          .fillers = {{.material = hard}},
          .packing = ExplicitPacking<dim>{.file = "listed.csv", .particles = std::move(particles), .walls = walls}};
}

std::optional<double> share_of(const Stage& stage) {
  return filler_on_sides(stage, make_microstructure(stage));
}

// A disc of radius 0.5 whose centre is 0.3 from the left side, and 0.4 from the upper one, has chords of 0.8 and 0.6.
TEST(FillerOnSides, IsTheChordsOfDiscs) {
  const std::vector<Disc> discs = {{{0.3, 1.6}, 1.0}};
  EXPECT_NEAR(share_of(box_of<2>(discs, Walls::periodic)).value(), (0.8 + 0.6) / 4.0, 1e-12);
}

// The circles of radii 0.4 and 0.3. The first goes beyond an edge of its side, and continues at the opposite edge.
TEST(FillerOnSides, IsTheCirclesOfSpheres) {
  const std::vector<Sphere> spheres = {{{0.3, 1.6, 1.0}, 1.0}};
  const double circles = std::numbers::pi * (0.4 * 0.4 + 0.3 * 0.3);
  EXPECT_NEAR(share_of(box_of<3>(spheres, Walls::periodic)).value(), circles / 12.0, 1e-12);
}

TEST(FillerOnSides, IsSampledForOtherShapes) {
  const std::vector<Particle> ellipses = {{Ellipse{{1.0, 1.0}}, Pose({0.3, 1.6}, 0.7)}};
  EXPECT_NEAR(share_of(box_of<2>(ellipses, Walls::periodic)).value(), (0.8 + 0.6) / 4.0, 1e-3);
}

TEST(FillerOnSides, IsOfAWindowAlone) {
  EXPECT_FALSE(share_of(box_of<2>(std::vector<Disc>{{{1.0, 1.0}, 1.0}}, Walls::hard)));
  EXPECT_EQ(share_of(box_of<2>(std::vector<Disc>{{{1.0, 1.0}, 1.0}}, Walls::periodic)), 0.0);
  EXPECT_FALSE(share_of({.name = "A", .matrix = soft, .side = 2.0, .cells = 10}));
}

// Pixels of filler along a whole side, and half of the two sides across it; the fourth has none.
TEST(FillerOnSides, IsThatOfTheFourSidesOfAnImage) {
  for (const auto walls : {Walls::hard, Walls::periodic}) {
    const LabelImage<2> image = {{2, 2}, 1.0, walls, {1, 1, 0, 0}};
    const Stage stage = {
        .name = "A",
        .matrix = soft,
        .side = 2.0,
        .cells = 2,
        .fillers = {{.material = hard}},
        .packing = ImagePacking<2>{.file = "half.png", .image = std::make_shared<const LabelImage<2>>(image)}};
    EXPECT_DOUBLE_EQ(share_of(stage).value(), (1.0 + 0.5 + 0.5 + 0.0) / 4.0) << "the sides do not fit together";
  }
}

}  // namespace
}  // namespace breccia
