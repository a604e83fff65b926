#include "breccia/microstructure/random_sequential.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/particle_box.hpp"

#include "expect_error.hpp"
#include "microstructure/shapes/particle_validity.hpp"

namespace breccia {
namespace {

using test::expect_error;

/// Ellipses of an equivalent diameter of 1, each with half a gap and a coating around it, that fill a fraction of a
/// box.
RandomSequentialRequest ellipses(std::size_t count, double fraction, double aspect, double gap, Walls walls,
                                 double coating = 0.0) {
  const double side = std::sqrt(0.25 * std::numbers::pi * static_cast<double>(count) / fraction);
  const ParticleToPlace particle = {
      Ellipse{{std::sqrt(aspect), 1.0 / std::sqrt(aspect)}}, {}, 0.5 * gap + coating, gap + coating};
  return {side, walls, {count, particle}, 3};
}

ParticleBox packed(const RandomSequentialRequest& request) {
  RandomSequentialRun run(request);
  while (!run.is_done()) run.advance();
  ParticleBox box = {request.side, request.walls, {}};
  for (std::size_t number = 0; number < request.particles.size(); ++number) {
    box.particles.push_back({request.particles[number].shape, run.poses()[number]});
  }
  return box;
}

TEST(RandomSequential, KeepsGapsBetweenParticlesAndToWalls) {
  const double gap = 0.05;
  for (const auto walls : {Walls::hard, Walls::periodic}) {
    for (const double fraction : {0.3, 0.6}) {
      const auto box = packed(ellipses(60, fraction, 2.0, gap, walls));
      EXPECT_NO_THROW(require_valid(box));
      EXPECT_NEAR(volume_fraction(box), fraction, 1e-12);
      EXPECT_GE(smallest_gap(box), gap);
      EXPECT_GE(smallest_wall_gap(box), gap);
    }
  }
}

TEST(RandomSequential, EllipsesOfAspectThreeHalvesFillSeventyPerCent) {
  const auto box = packed(ellipses(100, 0.70, 1.5, 0.02, Walls::periodic));
  EXPECT_NO_THROW(require_valid(box));
  EXPECT_NEAR(volume_fraction(box), 0.70, 1e-12);
  EXPECT_GE(smallest_gap(box), 0.02);
}

TEST(RandomSequential, ShellsOfCoatingsDoNotOverlap) {
  auto box = packed(ellipses(40, 0.45, 1.5, 0.03, Walls::hard, 0.05));
  box.coatings.assign(box.particles.size(), 0.05);
  EXPECT_GE(smallest_gap(box), 0.03);
  EXPECT_GE(smallest_wall_gap(box), 0.03);
}

TEST(RandomSequential, PlacesPolygonsAndEllipsesTogether) {
  auto request = ellipses(30, 0.3, 1.5, 0.05, Walls::periodic);
  for (auto& particle : request.particles) particle.angle = 0.5;
  const ConvexPolygon square({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}});
  request.particles.insert(request.particles.end(), 20, {square, {}, 0.025, 0.05});
  const auto box = packed(request);
  EXPECT_NO_THROW(require_valid(box));
  EXPECT_GE(smallest_gap(box), 0.05);
  EXPECT_EQ(box.particles.front().pose.angle(), 0.5);
  EXPECT_NE(box.particles[40].pose.angle(), box.particles[41].pose.angle());
}

TEST(RandomSequential, TheSameSeedGivesTheSamePackingAndAnotherSeedAnotherOne) {
  auto request = ellipses(30, 0.5, 1.5, 0.05, Walls::periodic);
  EXPECT_EQ(packed(request).particles, packed(request).particles);
  const auto first = packed(request).particles;
  request.seed = 4;
  EXPECT_NE(packed(request).particles, first);
}

TEST(RandomSequential, SaysHowFarParticlesCameThatJam) {
  const auto jam = [] {
    RandomSequentialRun run(ellipses(20, 0.9, 1.5, 0.1, Walls::hard));
    while (!run.is_done()) run.advance();
  };
  expect_error<PackingError>(jam, "20 particles jam", "instead of 0.9");
}

TEST(RandomSequential, RefusesWhatCannotBePlaced) {
  auto wide = ellipses(1, 0.5, 4.0, 0.0, Walls::hard);
  wide.particles.front().angle = 0.0;
  expect_error<PackingError>([&] { RandomSequentialRun{wide}; }, "does not fit");
  // A particle that is longer than a periodic box would overlap its own images.
  expect_error<PackingError>([&] { RandomSequentialRun{ellipses(1, 0.1257, 9.0, 0.0, Walls::periodic)}; },
                             "does not fit");
  auto no_side = ellipses(3, 0.5, 1.5, 0.0, Walls::hard);
  no_side.side = 0.0;
  expect_error<InputError>([&] { RandomSequentialRun{no_side}; }, "side of the box");
  auto none = ellipses(3, 0.5, 1.5, 0.0, Walls::hard);
  none.particles.clear();
  expect_error<InputError>([&] { RandomSequentialRun{none}; }, "no particles");
  auto flat = ellipses(3, 0.5, 1.5, 0.0, Walls::hard);
  flat.particles[1].shape = Ellipse{{1.0, 0.0}};
  expect_error<InputError>([&] { RandomSequentialRun{flat}; }, "positive area");
  auto negative = ellipses(3, 0.5, 1.5, 0.0, Walls::hard);
  negative.particles[1].shell = -1.0;
  expect_error<InputError>([&] { RandomSequentialRun{negative}; }, "shells");
}

TEST(RandomSequential, ProgressRisesToTheFraction) {
  RandomSequentialRun run(ellipses(30, 0.6, 1.5, 0.02, Walls::periodic));
  double fraction = 0.0;
  while (!run.is_done()) {
    run.advance();
    EXPECT_GE(run.progress().fraction, fraction);
    fraction = run.progress().fraction;
  }
  EXPECT_NEAR(fraction, run.progress().fraction_to_reach, 1e-12);
  EXPECT_GT(run.progress().events, 0U);
}

}  // namespace
}  // namespace breccia
