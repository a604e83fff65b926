#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/ellipsoid_box.hpp"
#include "breccia/microstructure/random_sequential.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;

/// Ellipsoids of revolution of the volume of a ball of diameter 1, each with half a gap and a coating around it, that
/// fill a fraction of a box.
EllipsoidSequentialRequest spheroids(std::size_t count, double fraction, double aspect, double gap, Walls walls,
                                     double coating = 0.0) {
  const double side = std::cbrt(std::numbers::pi / 6.0 * static_cast<double>(count) / fraction);
  const double across = 1.0 / std::cbrt(aspect);
  const EllipsoidToPlace particle = {{aspect * across, across, across}, 0.5 * gap + coating, gap + coating};
  return {side, walls, {count, particle}, 3};
}

EllipsoidBox packed(const EllipsoidSequentialRequest& request, double coating = 0.0) {
  EllipsoidSequentialRun run(request);
  while (!run.is_done()) run.advance();
  EllipsoidBox box = {request.side, request.walls, {}, {}, {}};
  for (std::size_t number = 0; number < request.particles.size(); ++number) {
    const auto& [centre, quaternion] = run.poses()[number];
    box.particles.push_back({centre, request.particles[number].axes, turned(quaternion)});
    if (coating > 0.0) box.coatings.push_back(coating);
  }
  return box;
}

TEST(EllipsoidPacking, KeepsGapsBetweenParticlesAndToWalls) {
  const double gap = 0.05, coating = 0.02;
  for (const auto walls : {Walls::hard, Walls::periodic}) {
    for (const double aspect : {0.5, 2.0}) {
      const auto box = packed(spheroids(30, 0.3, aspect, gap, walls, coating), coating);
      EXPECT_NO_THROW(require_valid(box));
      EXPECT_NEAR(volume_fraction(box), 0.3, 1e-12);
      EXPECT_GE(smallest_gap(box), gap);
      EXPECT_GE(smallest_wall_gap(box), gap);
    }
  }
}

TEST(EllipsoidPacking, PointsEveryWay) {
  // The mean of n n over random directions is a third of the unit tensor.
  const auto box = packed(spheroids(150, 0.1, 2.0, 0.0, Walls::periodic));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double square = 0.0;
    for (const auto& particle : box.particles) square += particle.directions[0][axis] * particle.directions[0][axis];
    EXPECT_NEAR(square / 150.0, 1.0 / 3.0, 0.08) << axis;
  }
}

TEST(EllipsoidPacking, TheSameSeedGivesTheSamePacking) {
  auto request = spheroids(20, 0.3, 1.5, 0.02, Walls::periodic);
  const auto box = packed(request), same = packed(request);
  EXPECT_EQ(box.particles, same.particles);
  request.seed = 4;
  EXPECT_NE(box.particles, packed(request).particles);
}

TEST(EllipsoidPacking, RefusesWhatHasNoRoom) {
  auto request = spheroids(1, 0.3, 1.0, 0.0, Walls::periodic);
  request.particles[0].axes = {1.1 * request.side, 0.1, 0.1};
  EXPECT_THROW(EllipsoidSequentialRun{request}, PackingError);
  request.walls = Walls::hard;
  EXPECT_NO_THROW(EllipsoidSequentialRun{request}) << "it fits along a diagonal";
  request.particles[0].axes[1] = 0.0;
  expect_error<InputError>([&] { EllipsoidSequentialRun{request}; }, "positive volume");
}

TEST(EllipsoidPacking, JamsAtTooHighAFraction) {
  EllipsoidSequentialRun run(spheroids(12, 0.8, 2.0, 0.0, Walls::periodic));
  const auto pack = [&] {
    while (!run.is_done()) run.advance();
  };
  EXPECT_THROW(pack(), PackingError);
}

}  // namespace
}  // namespace breccia
