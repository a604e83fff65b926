#include "breccia/microstructure/packing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/size_distribution.hpp"
#include "breccia/microstructure/statistics.hpp"
#include "breccia/microstructure/validity.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;

SizeDistribution hmx() {
  return SizeDistribution::lognormal_mixture({{0.75, 154e-6, 0.76}, {0.25, 12.7e-6, 1.09}});
}

PackingRequest hb1() {
  return {48e-6, Walls::hard, draw_diameters(hmx().truncated(2e-6, 14e-6), 0.65, 48e-6), 0.5e-6};
}

/// Equal discs of 1 mm at this fraction.
PackingRequest equal(std::size_t count, double fraction, Walls walls) {
  const double diameter = 1e-3;
  const double side = diameter * std::sqrt(static_cast<double>(count) * std::numbers::pi / 4.0 / fraction);
  return {side, walls, std::vector<double>(count, diameter)};
}

/// The smallest gap by comparing all with all, and the largest with its image.
double smallest_gap_of_all_pairs(const PackingRequest& request, const std::vector<Disc>& discs) {
  double smallest = std::numeric_limits<double>::infinity();
  if (request.walls == Walls::periodic) smallest = request.side - std::ranges::max(request.diameters);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      double x = std::abs(discs[i].centre[0] - discs[j].centre[0]);
      double y = std::abs(discs[i].centre[1] - discs[j].centre[1]);
      if (request.walls == Walls::periodic) {
        x = std::min(x, request.side - x);
        y = std::min(y, request.side - y);
      }
      smallest = std::min(smallest, std::hypot(x, y) - 0.5 * (discs[i].diameter + discs[j].diameter));
    }
  }
  return smallest;
}

struct Case {
  const char* name;
  PackingRequest request;

  friend std::ostream& operator<<(std::ostream& out, const Case& entry) { return out << entry.name; }
};

class Pack : public ::testing::TestWithParam<Case> {};

TEST_P(Pack, KeepsTheGapTheBoxAndTheSizes) {
  const PackingRequest& request = GetParam().request;
  const auto packing = pack<2>(request);
  const Microstructure microstructure{request.side, request.walls, packing.balls};

  ASSERT_EQ(packing.balls.size(), request.diameters.size());
  for (std::size_t k = 0; k < packing.balls.size(); ++k) EXPECT_EQ(packing.balls[k].diameter, request.diameters[k]);
  const double gap = smallest_gap_of_all_pairs(request, packing.balls);
  EXPECT_GE(gap, request.minimum_gap);
  EXPECT_TRUE(packing.gap == gap || std::abs(packing.gap - gap) < 1e-12 * request.side) << packing.gap << ", " << gap;
  EXPECT_GE(smallest_wall_gap(microstructure), 0.5 * request.minimum_gap);
  EXPECT_NEAR(packing.fraction, area_fraction(microstructure), 1e-12);
  EXPECT_NO_THROW(require_valid(microstructure));
}

std::vector<Case> cases() {
  const auto wide = draw_diameters(hmx().truncated(2e-6, 200e-6), 0.80, 400e-6);
  return {{"HB1", hb1()},
          {"HB2", {420e-6, Walls::hard, draw_diameters(hmx().truncated(14e-6, 100e-6), 0.63, 420e-6), 4.2e-6}},
          {"HB3", {2.75e-3, Walls::hard, draw_diameters(hmx().truncated(100e-6, 600e-6), 0.52, 2.75e-3), 27.5e-6}},
          {"EqualDense", equal(1000, 0.82, Walls::hard)},
          {"EqualPeriodic", equal(500, 0.80, Walls::periodic)},
          {"WideRange", {400e-6, Walls::hard, wide}},
          {"WideRangePeriodic", {400e-6, Walls::periodic, wide}},
          {"OneDisc", equal(1, 0.7, Walls::hard)},
          {"OneDiscPeriodic", equal(1, 0.7, Walls::periodic)},
          {"TwoDiscsPeriodic", equal(2, 0.7, Walls::periodic)},
          {"FourDiscs", equal(4, 0.7, Walls::hard)},
          {"Dilute", equal(50, 0.001, Walls::periodic)}};
}

INSTANTIATE_TEST_SUITE_P(Cases, Pack, ::testing::ValuesIn(cases()),
                         [](const auto& instance) { return instance.param.name; });

TEST(Packing, TheSeedDecides) {
  PackingRequest request = hb1();
  const auto first = pack<2>(request);
  EXPECT_EQ(first.balls, pack<2>(request).balls);
  request.seed = 2;
  EXPECT_NE(first.balls, pack<2>(request).balls);
}

TEST(Packing, IsTheSameInEveryUnitOfLength) {
  PackingRequest request = hb1();
  const auto small = pack<2>(request);
  const double factor = 1024.0;  // changes no digit
  request.side *= factor;
  request.minimum_gap *= factor;
  for (double& diameter : request.diameters) diameter *= factor;
  const auto large = pack<2>(request);
  for (std::size_t k = 0; k < small.balls.size(); ++k) {
    for (std::size_t d = 0; d < 2; ++d) EXPECT_EQ(large.balls[k].centre[d], factor * small.balls[k].centre[d]);
  }
}

TEST(Packing, DiscsSpreadEvenlyOverTheBox) {
  const auto request = equal(900, 0.7, Walls::periodic);
  std::vector<int> discs_in_quarter(4, 0);
  for (const Disc& disc : pack<2>(request).balls) {
    const bool right = disc.centre[0] > 0.5 * request.side;
    const bool top = disc.centre[1] > 0.5 * request.side;
    ++discs_in_quarter[(right ? 1U : 0U) + (top ? 2U : 0U)];
  }
  // incompressible at this density: fluctuations far below the 13 of random points
  for (const int discs : discs_in_quarter) EXPECT_NEAR(discs, 225, 15);
}

TEST(Packing, ReportsProgress) {
  double last = -1.0;
  double to_reach = 0.0;
  const auto packing = pack<2>(hb1(), [&](const PackingProgress& progress) {
    EXPECT_GE(progress.fraction, last);
    last = progress.fraction;
    to_reach = progress.fraction_to_reach;
    return true;
  });
  EXPECT_DOUBLE_EQ(last, packing.fraction);
  EXPECT_DOUBLE_EQ(to_reach, packing.fraction);
}

TEST(Packing, StopsWhenTold) {
  expect_error<Interrupted>([] { return pack<2>(hb1(), [](const PackingProgress&) { return false; }); },
                            "packing interrupted");
}

TEST(Packing, RefusesWhatIsKnownToBeImpossible) {
  // above the hexagonal packing, pi / sqrt(12) = 0.9069
  expect_error<NumericalError>([] { return pack<2>(equal(100, 0.91, Walls::periodic)); }, "100 discs", "0.91",
                               "0.9069");
  PackingRequest crowded = hb1();
  crowded.minimum_gap = 2e-6;
  expect_error<NumericalError>([&] { return pack<2>(crowded); }, "cannot keep a gap of 2e-06 m");
  expect_error<NumericalError>(
      [] {
        return pack<2>({1e-3, Walls::hard, {0.9e-3}, 0.2e-3});
      },
      "does not fit", "0.001 m");
}

TEST(Packing, ImpossibleRequestsEndWithWhatWasReached) {
  // no two discs in a square have more than 2 pi / (2 + sqrt 2)^2 = 0.5390
  expect_error<NumericalError>([] { return pack<2>(equal(2, 0.545, Walls::hard)); }, "2 particles jam at 99.4");
  expect_error<NumericalError>([] { return pack<2>(equal(100, 0.905, Walls::hard)); }, "100 particles jam at 9",
                               "0.905");
}

TEST(Packing, ReachesTheDensestPackingOfTwoDiscs) {
  EXPECT_EQ(pack<2>(equal(2, 0.5389, Walls::hard)).balls.size(), 2U);
}

TEST(Packing, BadArguments) {
  const std::vector<double> one = {1e-4};
  expect_error<InputError>([&] { return pack<2>({0.0, Walls::hard, one}); }, "side", "0 m");
  expect_error<InputError>([] { return pack<2>({1e-3, Walls::hard, {}}); }, "no particles");
  expect_error<InputError>([] { return pack<2>({1e-3, Walls::hard, {1e-4, -1e-4}}); }, "diameter", "-0.0001 m");
  expect_error<InputError>([&] { return pack<2>({1e-3, Walls::hard, one, -1e-6}); }, "gap", "-1e-06 m");
  expect_error<InputError>([&] { return pack<2>({1e-3, Walls::hard, one, 0.0, 1, 0.0}); }, "growth rate", "got 0");
}

}  // namespace
}  // namespace breccia
