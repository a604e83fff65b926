#include "breccia/microstructure/particle_box.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/statistics.hpp"

#include "expect_error.hpp"
#include "microstructure/shapes/particle_locator.hpp"
#include "microstructure/shapes/particle_validity.hpp"

namespace breccia {
namespace {

using test::expect_error;

Particle ellipse(const Vector<2>& axes, const Vector<2>& centre, double angle = 0.0) {
  return {Ellipse{axes}, Pose(centre, angle)};
}

Particle square(double side, const Vector<2>& centre, double angle = 0.0) {
  const double half = 0.5 * side;
  return {ConvexPolygon({{-half, -half}, {half, -half}, {half, half}, {-half, half}}), Pose(centre, angle)};
}

TEST(ParticleBox, MeasuresAnEllipseAndASquare) {
  const ParticleBox box = {10.0, Walls::hard, {ellipse({4.0, 2.0}, {3.0, 5.0}), square(2.0, {7.0, 5.0})}};
  EXPECT_DOUBLE_EQ(volume_fraction(box), (2.0 * std::numbers::pi + 4.0) / 100.0);
  EXPECT_NEAR(specific_surface(box), (9.688448220547675 + 8.0) / 100.0, 1e-14);
  EXPECT_NEAR(smallest_gap(box), 1.0, 1e-13);
  EXPECT_NEAR(smallest_wall_gap(box), 1.0, 1e-14);
}

TEST(ParticleBox, CoatingsCountInGapsAndHaveAnAreaOfTheirOwn) {
  const ParticleBox box = {10.0, Walls::hard, {square(2.0, {3.0, 5.0}), square(2.0, {7.0, 5.0})}, {0, 1}, {0.0, 0.5}};
  EXPECT_NEAR(smallest_gap(box), 1.5, 1e-13);
  EXPECT_NEAR(smallest_wall_gap(box), 1.5, 1e-14);
  EXPECT_NEAR(coating_fraction(box), (8.0 * 0.5 + std::numbers::pi * 0.25) / 100.0, 1e-15);
}

TEST(ParticleBox, AThickCoatingFarAwayIsSeen) {
  ParticleBox box = {10.0, Walls::hard, {}, {}, {}};
  for (const double x : {0.5, 0.8}) box.particles.push_back(ellipse({0.1, 0.1}, {x, 1.0}));
  for (const double x : {5.0, 8.0}) box.particles.push_back(ellipse({0.1, 0.1}, {x, 8.0}));
  box.coatings = {0.0, 0.0, 1.4, 1.4};
  EXPECT_NEAR(smallest_gap(box), 0.1, 1e-13);
}

TEST(ParticleBox, GapsReachAcrossTheSidesOfAPeriodicBox) {
  ParticleBox box = {10.0, Walls::periodic, {ellipse({4.0, 2.0}, {1.0, 5.0}), square(2.0, {8.0, 5.0})}};
  EXPECT_NEAR(smallest_gap(box), 0.0, 1e-13);
  box.particles.pop_back();
  EXPECT_NEAR(smallest_gap(box), 6.0, 1e-13);
  EXPECT_EQ(smallest_wall_gap(box), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(smallest_side_distance(box), -1.0, 1e-14);
}

TEST(ParticleBox, CirclesAreDiscs) {
  ParticleBox box = {10.0, Walls::hard, {ellipse({2.0, 2.0}, {3.0, 5.0}, 0.7)}};
  ASSERT_TRUE(as_discs(box));
  EXPECT_EQ(as_discs(box)->particles, (std::vector<Disc>{{{3.0, 5.0}, 2.0}}));
  box.particles.push_back(square(1.0, {7.0, 7.0}));
  EXPECT_FALSE(as_discs(box));
}

TEST(ParticleBox, RefusesParticlesThatCannotBeThere) {
  const auto require = [](const ParticleBox& box) { return [box] { require_valid(box); }; };
  EXPECT_NO_THROW(require_valid({10.0, Walls::hard, {ellipse({4.0, 2.0}, {2.0, 5.0}), square(2.0, {5.0, 5.0})}}));
  expect_error<InputError>(require({10.0, Walls::hard, {ellipse({4.0, 2.0}, {1.9, 5.0})}}), "particle 1", "4 m x 2 m",
                           "crosses a wall by 0.1 m");
  expect_error<InputError>(require({10.0, Walls::hard, {ellipse({4.0, 0.0}, {5.0, 5.0})}}), "axes must be positive");
  expect_error<InputError>(require({10.0, Walls::periodic, {ellipse({4.0, 2.0}, {5.0, 10.5})}}), "outside the box");
  expect_error<InputError>(require({10.0, Walls::periodic, {ellipse({11.0, 2.0}, {5.0, 5.0})}}), "own periodic image");
  expect_error<InputError>(require({10.0, Walls::hard, {ellipse({4.0, 2.0}, {3.0, 5.0}), square(2.0, {5.9, 5.0})}}),
                           "particle 1", "particle 2 (polygon of 4 corners", "overlap by 0.1 m");
  expect_error<InputError>(
      require({10.0, Walls::hard, {square(2.0, {3.0, 5.0}), square(2.0, {5.5, 5.0})}, {}, {0.3, 0.3}}),
      "overlap by 0.1 m");
  expect_error<InputError>(require({-1.0, Walls::hard, {}}), "must be positive");
}

TEST(ParticleLocator, FindsTheParticleThatAPlaceIsIn) {
  const ParticleBox box = {10.0, Walls::periodic, {ellipse({4.0, 2.0}, {0.5, 5.0}), square(2.0, {5.0, 5.0})}};
  const ParticleLocator locator(box);
  EXPECT_EQ(locator.at({1.0, 5.5}).particle, 0U);
  EXPECT_LE(locator.at({1.0, 5.5}).distance, 0.0);
  EXPECT_EQ(locator.at({9.0, 5.0}).particle, 0U);  // its image
  EXPECT_NEAR(locator.at({9.0, 5.0}).distance, -0.25, 1e-14);
  EXPECT_EQ(locator.at({5.3, 4.2}).particle, 1U);
  const auto between = locator.at({3.5, 5.0});
  EXPECT_EQ(between.particle, 1U);
  EXPECT_NEAR(between.distance, 0.5, 1e-14);
}

TEST(ParticleLocator, NothingIsNearerThanItSays) {
  ParticleBox box = {1.0, Walls::periodic, {}};
  for (int k = 0; k < 30; ++k) {
    const double x = std::fmod(0.618034 * k, 1.0);
    box.particles.push_back(ellipse({0.06, 0.02}, {x, (k + 0.5) / 30.0}, 0.4 * k));
  }
  const ParticleLocator locator(box);
  for (int k = 0; k < 500; ++k) {
    const Vector<2> point = {std::fmod(0.7548777 * k, 1.0), std::fmod(0.5698403 * k, 1.0)};
    double nearest = 1.0;
    for_each_image(box, [&](std::size_t number, const Pose& pose) {
      nearest = std::min(nearest, signed_distance({box.particles[number].shape, pose}, point));
    });
    const auto found = locator.at(point);
    EXPECT_LE(found.distance, nearest + 1e-15);
    if (found.particle) {
      EXPECT_NEAR(found.distance, nearest, 1e-14);
    }
  }
}

}  // namespace
}  // namespace breccia
