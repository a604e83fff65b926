#include "microstructure/tessellation/site_weights.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/tessellation.hpp"

#include "brute_force_tessellation.hpp"
#include "expect_error.hpp"
#include "microstructure/tessellation/tessellation_statistics.hpp"

namespace breccia {
namespace {

using test::expect_error;
using test::random_points;

template <int dim>
LaguerreSites<dim> sites_at_random(std::size_t count, Walls walls, std::uint64_t seed) {
  LaguerreSites<dim> sites{1.0, walls, {}};
  for (const auto& point : random_points<dim>(count, 1.0, seed)) sites.sites.push_back({point, 0.0});
  return sites;
}

template <int dim>
double error_with(LaguerreSites<dim> sites, const std::vector<double>& weights, const std::vector<double>& volumes) {
  for (std::size_t site = 0; site < weights.size(); ++site) sites.sites[site].weight = weights[site];
  return largest_volume_error<dim>(Tessellation<dim>(sites), volumes);
}

TEST(SiteWeights, OfBandsAreKnown) {
  // The plane between two sites L/2 apart moves by (w1 - w2) / L, on both sides.
  const LaguerreSites<2> sites{4.0, Walls::periodic, {{{1.0, 2.0}, 0.0}, {{3.0, 2.0}, 0.0}}};
  const auto [weights, error, steps] = weights_for_volumes<2>(sites, std::vector{3.0, 1.0});
  EXPECT_NEAR(weights[0] - weights[1], 2.0, 1e-12);  // widths of 3 and 1: the planes move by 0.5
  EXPECT_LT(error, 1e-9);
  EXPECT_EQ(steps, 1);  // the volumes are linear in the weights
}

TEST(SiteWeights, EqualVolumesOnALatticeNeedNone) {
  const LaguerreSites<3> sites{1.0, Walls::periodic, {{{0.1, 0.2, 0.3}, 5.0}, {{0.6, 0.7, 0.8}, 5.0}}};
  const auto found = weights_for_volumes<3>(sites, std::vector{2.0, 2.0});
  EXPECT_EQ(found.steps, 0);
  EXPECT_EQ(found.weights[0], 5.0);
}

TEST(SiteWeights, OneSiteHasEverything) {
  const auto found = weights_for_volumes<2>({1.0, Walls::hard, {{{0.1, 0.2}, 0.0}}}, std::vector{3.0});
  EXPECT_EQ(found.steps, 0);
}

// Random sites with volumes independent of their positions: the hardest case for the weights.
TEST(SiteWeights, FoundForAnyVolumes) {
  for (const auto walls : {Walls::periodic, Walls::hard}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto plane = sites_at_random<2>(60, walls, seed);
      std::vector<double> volumes;
      for (const auto& [x, y] : random_points<2>(60, 1.0, seed + 100)) volumes.push_back(std::pow(100.0, x));
      EXPECT_LE(error_with(plane, weights_for_volumes<2>(plane, volumes).weights, volumes), 1.1e-9) << seed;
      const auto space = sites_at_random<3>(60, walls, seed);
      EXPECT_LE(error_with(space, weights_for_volumes<3>(space, volumes).weights, volumes), 1.1e-9) << seed;
    }
  }
}

TEST(SiteWeights, BeginsWithEqualWeightsWhereTheGivenLeaveACellEmpty) {
  auto sites = sites_at_random<2>(20, Walls::periodic, 1);
  sites.sites[3].weight = 10.0;
  const std::vector<double> volumes(20, 1.0);
  EXPECT_LE(error_with(sites, weights_for_volumes<2>(sites, volumes).weights, volumes), 1.1e-9);
}

TEST(SiteWeights, BadArguments) {
  const auto sites = sites_at_random<2>(3, Walls::periodic, 1);
  expect_error<InputError>([&] { return weights_for_volumes<2>(sites, std::vector{1.0, 2.0}); }, "3 sites", "got 2");
  for (const double volume : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    expect_error<InputError>(
        [&] {
          return weights_for_volumes<2>(sites, std::vector{1.0, volume, 2.0});
        },
        "volume of site 2 must be positive");
  }
  expect_error<InputError>([&] { return weights_for_volumes<2>(sites, std::vector{1.0, 1.0, 2.0}, 0.0); }, "tolerance");
  auto outside = sites;
  outside.sites[1].position[0] = 2.0;
  expect_error<InputError>(
      [&] {
        return weights_for_volumes<2>(outside, std::vector{1.0, 1.0, 2.0});
      },
      "site 2", "outside the box");
  auto coincident = sites;
  coincident.sites[2] = coincident.sites[0];
  expect_error<InputError>(
      [&] {
        return weights_for_volumes<2>(coincident, std::vector{1.0, 1.0, 2.0});
      },
      "site 3", "no point");
}

TEST(SiteWeights, NoEndBelowRoundoff) {
  const auto sites = sites_at_random<2>(50, Walls::periodic, 1);
  std::vector<double> volumes(50);
  std::iota(volumes.begin(), volumes.end(), 1.0);
  expect_error<NumericalError>([&] { return weights_for_volumes<2>(sites, volumes, 1e-18); }, "1e-18");
}

}  // namespace
}  // namespace breccia
