#include "breccia/microstructure/random_sites.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gmock/gmock.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/ball.hpp"
#include "breccia/microstructure/draw_diameters.hpp"

#include "brute_force_tessellation.hpp"
#include "expect_error.hpp"
#include "hmx_sizes.hpp"
#include "microstructure/tessellation/tessellation_statistics.hpp"

namespace breccia {
namespace {

using test::diameters_of_ratio;
using test::expect_error;

/// Areas of discs, or volumes of balls.
template <int dim>
std::vector<double> volumes_of(const std::vector<double>& diameters) {
  std::vector<double> volumes;
  volumes.reserve(diameters.size());
  for (const double diameter : diameters) volumes.push_back(ball_volume<dim>(diameter));
  return volumes;
}

TEST(RandomSites, CellsHaveTheSizesOfHmx) {
  const auto diameters = draw_diameters<2>(test::hmx().truncated(9.5e-6, 500e-6), 0.937, 0.7e-3);
  ASSERT_GT(diameters.size(), 300);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Tessellation<2> tessellation(random_sites<2>({0.7e-3, Walls::periodic, diameters, seed}));
    EXPECT_LE(largest_volume_error<2>(tessellation, volumes_of<2>(diameters)), 2e-9) << seed;
    const auto found = statistics(tessellation, film_thickness(tessellation, 0.937));
    EXPECT_NEAR(found.fraction, 0.937, 1e-12);
    EXPECT_NEAR(found.mean_faces, 6.0, 1e-12);  // Euler: three films meet in a point
    EXPECT_LT(found.aspect_ratio.mean, 1.8);
  }
}

TEST(RandomSites, InThreeDimensionsAndBetweenWalls) {
  const auto diameters = diameters_of_ratio(80, 6.0);
  for (const auto walls : {Walls::periodic, Walls::hard}) {
    const Tessellation<3> tessellation(random_sites<3>({1.0, walls, diameters, 1, 2}));
    EXPECT_LE(largest_volume_error<3>(tessellation, volumes_of<3>(diameters)), 2e-9);
    const Tessellation<2> plane(random_sites<2>({1.0, walls, diameters, 1, 2}));
    EXPECT_LE(largest_volume_error<2>(plane, volumes_of<2>(diameters)), 2e-9);
  }
}

TEST(RandomSites, CentringMakesGrainsRounder) {
  const auto mean_aspect_ratio = [](int centring_steps) {
    const auto sites = random_sites<2>({1.0, Walls::periodic, diameters_of_ratio(200, 10.0), 4, centring_steps});
    return statistics(Tessellation<2>(sites), 0.0).aspect_ratio.mean;
  };
  const double rounder = mean_aspect_ratio(8);
  EXPECT_LT(rounder, 0.8 * mean_aspect_ratio(0));
  EXPECT_LT(rounder, 1.5);
}

TEST(RandomSites, TheSeedDecides) {
  const auto sites = [](std::uint64_t seed) {
    return random_sites<2>({1.0, Walls::periodic, diameters_of_ratio(40, 10.0), seed}).sites;
  };
  const auto first = sites(1);
  const auto again = sites(1);
  const auto other = sites(2);
  for (std::size_t site = 0; site < first.size(); ++site) {
    EXPECT_EQ(first[site].position, again[site].position);
    EXPECT_EQ(first[site].weight, again[site].weight);
    EXPECT_NE(first[site].position, other[site].position);
  }
}

TEST(RandomSites, FewGrains) {
  for (const std::vector<double>& diameters : {std::vector{1.0}, {1.0, 30.0}, {1.0, 1.0, 1.0}}) {
    for (const auto walls : {Walls::periodic, Walls::hard}) {
      const Tessellation<2> plane(random_sites<2>({1.0, walls, diameters, 3}));
      EXPECT_LE(largest_volume_error<2>(plane, volumes_of<2>(diameters)), 2e-9);
      const Tessellation<3> space(random_sites<3>({1.0, walls, diameters, 3}));
      EXPECT_LE(largest_volume_error<3>(space, volumes_of<3>(diameters)), 2e-9);
    }
  }
}

TEST(RandomSites, BadRequests) {
  const auto request = [](double side, const std::vector<double>& diameters, int centring_steps) {
    return RandomTessellationRequest{side, Walls::periodic, diameters, 1, centring_steps};
  };
  expect_error<InputError>([&] { return random_sites<2>(request(0.0, {1.0}, 1)); }, "side of the box");
  expect_error<InputError>([&] { return random_sites<2>(request(1.0, {}, 1)); }, "from 1 to");
  expect_error<InputError>([&] { return random_sites<2>(request(1.0, {1.0, -1.0}, 1)); }, "diameter", "-1");
  expect_error<InputError>([&] { return random_sites<3>(request(1.0, {1.0}, -1)); }, "centring steps");
}

}  // namespace
}  // namespace breccia
