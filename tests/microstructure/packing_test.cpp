#include "breccia/microstructure/packing.hpp"

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
#include "breccia/microstructure/statistics.hpp"
#include "breccia/microstructure/validity.hpp"

#include "expect_error.hpp"
#include "hmx_sizes.hpp"
#include "messages.hpp"

namespace breccia {
namespace {

using test::expect_error;
using test::hmx;

PackingRequest hb1() {
  return {48e-6, Walls::hard, draw_diameters<2>(hmx().truncated(2e-6, 14e-6), 0.65, 48e-6), 0.5e-6};
}

/// Equal discs of 1 mm at this fraction.
PackingRequest equal(std::size_t count, double fraction, Walls walls) {
  const double diameter = 1e-3;
  const double side = diameter * std::sqrt(static_cast<double>(count) * std::numbers::pi / 4.0 / fraction);
  return {side, walls, std::vector<double>(count, diameter)};
}

/// The smallest gap by comparing all pairs of particles, and the largest particle with its image.
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
  const Microstructure<2> microstructure{request.side, request.walls, packing.balls};

  ASSERT_EQ(packing.balls.size(), request.diameters.size());
  for (std::size_t k = 0; k < packing.balls.size(); ++k) EXPECT_EQ(packing.balls[k].diameter, request.diameters[k]);
  const double gap = smallest_gap_of_all_pairs(request, packing.balls);
  EXPECT_GE(gap, request.minimum_gap);
  EXPECT_TRUE(packing.gap == gap || std::abs(packing.gap - gap) < 1e-12 * request.side) << packing.gap << ", " << gap;
  EXPECT_GE(smallest_wall_gap(microstructure), 0.5 * request.minimum_gap);
  EXPECT_NEAR(packing.fraction, volume_fraction(microstructure), 1e-12);
  EXPECT_NO_THROW(require_valid(microstructure));
}

std::vector<Case> cases() {
  const auto wide = draw_diameters<2>(hmx().truncated(2e-6, 200e-6), 0.80, 400e-6);
  return {{"HB1", hb1()},
          {"HB2", {420e-6, Walls::hard, draw_diameters<2>(hmx().truncated(14e-6, 100e-6), 0.63, 420e-6), 4.2e-6}},
          {"HB3", {2.75e-3, Walls::hard, draw_diameters<2>(hmx().truncated(100e-6, 600e-6), 0.52, 2.75e-3), 27.5e-6}},
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
  const double factor = 1024.0;  // a power of two changes no digit
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
  PackingRun<2> run(hb1());
  double last = -1.0;
  while (!run.is_done()) {
    run.advance();
    EXPECT_GE(run.progress().fraction, last);
    last = run.progress().fraction;
  }
  EXPECT_DOUBLE_EQ(last, run.packing().fraction);
  EXPECT_DOUBLE_EQ(run.progress().fraction_to_reach, run.packing().fraction);
}

/// Packs in a run that is restarted from its state after every step.
Packing<2> pack_in_parts(const PackingRequest& request) {
  PackingRun<2> run(request);
  while (!run.is_done()) {
    run.advance();
    run = PackingRun<2>(request, run.state());
  }
  return run.packing();
}

TEST(Packing, GoesOnFromItsStateToTheSameBits) {
  for (const auto& request : {hb1(), equal(300, 0.84, Walls::periodic), equal(1, 0.7, Walls::hard)}) {
    const auto whole = pack<2>(request), in_parts = pack_in_parts(request);
    EXPECT_EQ(in_parts.balls, whole.balls);
    EXPECT_EQ(in_parts.events, whole.events);
  }
}

TEST(Packing, JamsFromItsStateAsItDoesInOneGo) {
  const auto request = equal(100, 0.905, Walls::hard);
  EXPECT_EQ(test::message_of<NumericalError>([&] { return pack_in_parts(request); }),
            test::message_of<NumericalError>([&] { return pack<2>(request); }));
}

TEST(Packing, BeginsAnewFromItsFirstState) {
  const auto request = hb1();
  PackingRun<2> run(request, PackingRun<2>(request).state());
  expect_error<InputError>([&] { return run.packing(); }, "have not reached their size");
  while (!run.is_done()) run.advance();
  EXPECT_EQ(run.packing().balls, pack<2>(request).balls);
}

TEST(Packing, RefusesTheStateOfAnother) {
  const auto request = equal(10, 0.5, Walls::hard);
  PackingRun<2> run(request);
  run.advance();
  const auto refuse = [&](const auto& spoil) {
    auto state = run.state();
    spoil(state);
    expect_error<InputError>([&] { return PackingRun<2>(request, state); }, "not one of these particles in this box");
  };
  EXPECT_NO_THROW(PackingRun<2>(request, run.state()));
  refuse([](PackingState<2>& state) { state.positions.pop_back(); });
  refuse([](PackingState<2>& state) { state.velocities.pop_back(); });
  refuse([](PackingState<2>& state) { state.queue_times.pop_back(); });
  refuse([](PackingState<2>& state) { state.queue[0] = state.queue[1]; });
  refuse([](PackingState<2>& state) { state.queue[0] = 10; });
  refuse([](PackingState<2>& state) { state.queue_times[9] = -1.0; });
  refuse([](PackingState<2>& state) { state.queue_times[0] = std::numeric_limits<double>::quiet_NaN(); });
  refuse([](PackingState<2>& state) { state.positions[3] = state.positions[4]; });
  refuse([](PackingState<2>& state) { state.positions[3][1] = 0.0; });
  refuse([](PackingState<2>& state) { state.positions[3][1] = 1e3; });
  refuse([](PackingState<2>& state) { state.positions[3][1] = std::numeric_limits<double>::quiet_NaN(); });
  refuse([](PackingState<2>& state) { state.velocities[3][0] = std::numeric_limits<double>::infinity(); });
  refuse([](PackingState<2>& state) { state.scale = 1.5; });
  refuse([](PackingState<2>& state) { state.jams = 3; });
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
  expect_error<NumericalError>([] { return pack<2>(equal(100, 0.905, Walls::hard)); }, "100 particles jam at 9",
                               "0.905");
}

/// The largest diameter [sides of the box] that a few equal discs can have, as proven.
struct DensestPacking {
  std::size_t discs;
  Walls walls;
  double diameter;
};

class PackDensest : public ::testing::TestWithParam<DensestPacking> {};

TEST_P(PackDensest, IsReachedAndNotPassed) {
  const auto& [discs, walls, diameter] = GetParam();
  const PackingRequest smaller{1.0, walls, std::vector<double>(discs, 0.9999 * diameter)};
  EXPECT_EQ(pack<2>(smaller).balls.size(), discs);
  const PackingRequest larger{1.0, walls, std::vector<double>(discs, 1.01 * diameter)};
  expect_error<NumericalError>([&] { return pack<2>(larger); }, "jam at 99.01 %");  // 1 / 1.01
}

/// The largest diameter of discs in a unit square, from the largest smallest distance of points in one.
double in_square(double distance) {
  return distance / (1.0 + distance);
}

constexpr auto by_number = [](const auto& chosen) { return fmt::format("{}_discs", chosen.param.discs); };
INSTANTIATE_TEST_SUITE_P(Square, PackDensest,
                         ::testing::Values(DensestPacking{2, Walls::hard, in_square(std::sqrt(2.0))},
                                           DensestPacking{3, Walls::hard, in_square(std::sqrt(6.0) - std::sqrt(2.0))},
                                           DensestPacking{4, Walls::hard, in_square(1.0)},
                                           DensestPacking{5, Walls::hard, in_square(std::sqrt(0.5))}),
                         by_number);
INSTANTIATE_TEST_SUITE_P(Torus, PackDensest,
                         ::testing::Values(DensestPacking{2, Walls::periodic, std::sqrt(0.5)},
                                           DensestPacking{3, Walls::periodic, 0.5 * (std::sqrt(6.0) - std::sqrt(2.0))},
                                           DensestPacking{4, Walls::periodic, 0.5 * (std::sqrt(6.0) - std::sqrt(2.0))}),
                         by_number);

TEST(Packing, KeepsShellsApart) {
  PackingRequest request;
  request.side = 1.0;
  request.minimum_gap = 0.01;
  request.diameters.assign(20, 0.1);
  auto with_zeros = request;
  with_zeros.shells.assign(20, 0.0);
  EXPECT_EQ(pack<2>(with_zeros).balls, pack<2>(request).balls);
  for (std::size_t ball = 0; ball < 20; ++ball) request.shells.push_back(ball % 2 == 0 ? 0.0 : 0.03);
  const auto balls = pack<2>(request).balls;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_EQ(balls[i].diameter, 0.1);
    for (std::size_t j = 0; j < i; ++j) {
      const double distance =
          std::hypot(balls[i].centre[0] - balls[j].centre[0], balls[i].centre[1] - balls[j].centre[1]);
      EXPECT_GE(distance, 0.1 + 0.01 + request.shells[i] + request.shells[j]);
    }
    for (const double x : balls[i].centre) {
      EXPECT_GE(x, 0.05 + 0.005 + request.shells[i]);
      EXPECT_LE(x, 1.0 - 0.05 - 0.005 - request.shells[i]);
    }
  }
  request.shells.pop_back();
  EXPECT_THROW((void)pack<2>(request), InputError);
  request.shells.push_back(-0.01);
  EXPECT_THROW((void)pack<2>(request), InputError);
}

TEST(Packing, BadArguments) {
  const std::vector<double> one = {1e-4};
  expect_error<InputError>([&] { return pack<2>({0.0, Walls::hard, one}); }, "side", "0 m");
  expect_error<InputError>([] { return pack<2>({1e-3, Walls::hard, {}}); }, "no particles");
  expect_error<InputError>([] { return pack<2>({1e-3, Walls::hard, {1e-4, -1e-4}}); }, "diameter", "-0.0001 m");
  expect_error<InputError>([&] { return pack<2>({1e-3, Walls::hard, one, -1e-6}); }, "gap", "-1e-06 m");
  expect_error<InputError>([&] { return pack<2>({1e-3, Walls::hard, one, 0.0, {}, 1, 0.0}); }, "growth rate", "got 0");
}

}  // namespace
}  // namespace breccia
