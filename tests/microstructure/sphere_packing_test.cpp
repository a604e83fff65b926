#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <ostream>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/draw_diameters.hpp"
#include "breccia/microstructure/packing.hpp"
#include "breccia/microstructure/statistics.hpp"
#include "breccia/microstructure/validity.hpp"

#include "expect_error.hpp"
#include "messages.hpp"

namespace breccia {
namespace {

using test::expect_error;

/// Equal spheres of 1 mm at this fraction.
PackingRequest equal(std::size_t count, double fraction, Walls walls) {
  const double diameter = 1e-3;
  const double side = diameter * std::cbrt(static_cast<double>(count) * std::numbers::pi / 6.0 / fraction);
  return {side, walls, std::vector<double>(count, diameter)};
}

PackingRequest sized(double smallest, double largest, double fraction, double side, double gap, Walls walls) {
  const auto sizes = SizeDistribution::lognormal_mixture({{1.0, 10e-6, 0.7}}).truncated(smallest, largest);
  return {side, walls, draw_diameters<3>(sizes, fraction, side), gap};
}

/// The smallest gap by comparing all pairs of particles, and the largest particle with its image.
double smallest_gap_of_all_pairs(const PackingRequest& request, const std::vector<Sphere>& spheres) {
  double smallest = std::numeric_limits<double>::infinity();
  if (request.walls == Walls::periodic) smallest = request.side - std::ranges::max(request.diameters);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      double square = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double apart = std::abs(spheres[i].centre[axis] - spheres[j].centre[axis]);
        if (request.walls == Walls::periodic) apart = std::min(apart, request.side - apart);
        square += apart * apart;
      }
      smallest = std::min(smallest, std::sqrt(square) - 0.5 * (spheres[i].diameter + spheres[j].diameter));
    }
  }
  return smallest;
}

struct Case {
  const char* name;
  PackingRequest request;

  friend std::ostream& operator<<(std::ostream& out, const Case& entry) { return out << entry.name; }
};

class PackSpheres : public ::testing::TestWithParam<Case> {};

TEST_P(PackSpheres, KeepsTheGapTheBoxAndTheSizes) {
  const PackingRequest& request = GetParam().request;
  const auto packing = pack<3>(request);
  const Microstructure<3> microstructure{request.side, request.walls, packing.balls};

  ASSERT_EQ(packing.balls.size(), request.diameters.size());
  for (std::size_t k = 0; k < packing.balls.size(); ++k) EXPECT_EQ(packing.balls[k].diameter, request.diameters[k]);
  const double gap = smallest_gap_of_all_pairs(request, packing.balls);
  EXPECT_GE(gap, request.minimum_gap);
  EXPECT_TRUE(packing.gap == gap || std::abs(packing.gap - gap) < 1e-12 * request.side) << packing.gap << ", " << gap;
  EXPECT_GE(smallest_wall_gap(microstructure), 0.5 * request.minimum_gap);
  EXPECT_NEAR(packing.fraction, volume_fraction(microstructure), 1e-12);
  EXPECT_NO_THROW(require_valid(microstructure));
}

INSTANTIATE_TEST_SUITE_P(Cases, PackSpheres,
                         ::testing::Values(Case{"EqualDense", equal(300, 0.55, Walls::hard)},
                                           Case{"EqualPeriodic", equal(500, 0.61, Walls::periodic)},
                                           Case{"TenToOne", sized(3e-6, 30e-6, 0.52, 60e-6, 0.2e-6, Walls::hard)},
                                           Case{"TenToOnePeriodic",
                                                sized(3e-6, 30e-6, 0.66, 55e-6, 0.0, Walls::periodic)},
                                           Case{"OneSphere", equal(1, 0.5, Walls::hard)},
                                           Case{"OneSpherePeriodic", equal(1, 0.5, Walls::periodic)},
                                           Case{"TwoSpheresPeriodic", equal(2, 0.6, Walls::periodic)},
                                           Case{"Dilute", equal(50, 0.001, Walls::periodic)}),
                         [](const auto& instance) { return instance.param.name; });

TEST(SpherePacking, TheSeedDecides) {
  PackingRequest request = equal(100, 0.5, Walls::hard);
  const auto first = pack<3>(request);
  EXPECT_EQ(first.balls, pack<3>(request).balls);
  request.seed = 2;
  EXPECT_NE(first.balls, pack<3>(request).balls);
}

TEST(SpherePacking, SpheresSpreadEvenlyOverTheBox) {
  const auto request = equal(800, 0.55, Walls::periodic);
  std::vector<int> spheres_in_eighth(8, 0);
  for (const Sphere& sphere : pack<3>(request).balls) {
    std::size_t eighth = 0;
    for (const double x : sphere.centre) eighth = 2 * eighth + (x > 0.5 * request.side ? 1 : 0);
    ++spheres_in_eighth[eighth];
  }
  // A dense fluid: its fluctuations are well below the 10 of random points.
  for (const int spheres : spheres_in_eighth) EXPECT_NEAR(spheres, 100, 15);
}

TEST(SpherePacking, GoesOnFromItsStateToTheSameBits) {
  for (const auto& request : {equal(200, 0.55, Walls::periodic), equal(50, 0.5, Walls::hard)}) {
    PackingRun<3> run(request);
    while (!run.is_done()) {
      run.advance();
      run = PackingRun<3>(request, run.state());
    }
    const auto in_parts = run.packing(), whole = pack<3>(request);
    EXPECT_EQ(in_parts.balls, whole.balls);
    EXPECT_EQ(in_parts.events, whole.events);
  }
}

TEST(SpherePacking, KeepsShellsApart) {
  auto request = equal(60, 0.2, Walls::periodic);
  request.minimum_gap = 0.05e-3;
  for (std::size_t ball = 0; ball < 60; ++ball) request.shells.push_back(ball % 2 == 0 ? 0.0 : 0.1e-3);
  auto coated = pack<3>(request).balls;
  for (std::size_t ball = 0; ball < 60; ++ball) coated[ball].diameter += 2.0 * request.shells[ball];
  EXPECT_GE(smallest_gap_of_all_pairs(request, coated), request.minimum_gap * (1.0 - 1e-12));
}

TEST(SpherePacking, RefusesWhatIsKnownToBeImpossible) {
  // Above the face-centred cubic packing, pi / sqrt(18) = 0.7405.
  expect_error<PackingError>([] { (void)pack<3>(equal(100, 0.75, Walls::periodic)); }, "100 spheres", "0.75", "0.7405");
  expect_error<PackingError>([] { (void)pack<3>({1e-3, Walls::hard, {0.9e-3}, 0.2e-3}); }, "does not fit");
}

TEST(SpherePacking, ImpossibleRequestsEndWithWhatWasReached) {
  expect_error<PackingError>([] { (void)pack<3>(equal(60, 0.73, Walls::hard)); }, "60 particles jam at", "0.73");
}

/// The largest diameter [sides of the box] that a few equal spheres can have, as proven.
struct DensestPacking {
  std::size_t spheres;
  double diameter;
};

class PackDensestSpheres : public ::testing::TestWithParam<DensestPacking> {};

TEST_P(PackDensestSpheres, IsReachedAndNotPassed) {
  const std::size_t spheres = GetParam().spheres;
  const double diameter = GetParam().diameter;
  EXPECT_EQ(pack<3>({1.0, Walls::hard, std::vector<double>(spheres, 0.9999 * diameter)}).balls.size(), spheres);
  expect_error<PackingError>(
      [&] {
        return pack<3>({1.0, Walls::hard, std::vector<double>(spheres, 1.01 * diameter)});
      },
      "jam at 99.01 %");  // 1 / 1.01
}

/// The largest diameter of spheres in a unit cube, from the largest smallest distance of points in one (Schaer,
/// Canadian Mathematical Bulletin 9 (1966) 265).
double in_cube(double distance) {
  return distance / (1.0 + distance);
}

INSTANTIATE_TEST_SUITE_P(Cube, PackDensestSpheres,
                         ::testing::Values(DensestPacking{2, in_cube(std::sqrt(3.0))},
                                           DensestPacking{4, in_cube(std::sqrt(2.0))}, DensestPacking{8, in_cube(1.0)}),
                         [](const auto& chosen) { return fmt::format("{}_spheres", chosen.param.spheres); });

}  // namespace
}  // namespace breccia
