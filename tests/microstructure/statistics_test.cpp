#include "breccia/microstructure/statistics.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>

#include "breccia/error.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;
using ::testing::DoubleEq;
using ::testing::ElementsAre;

constexpr double no_gap = std::numeric_limits<double>::infinity();

/// Discs of diameter 2 and 4 in a box of 10; their surfaces are 2 apart inside it and 1 apart across the sides x =
/// 0, 10.
Microstructure<2> two_discs(Walls walls) {
  return {10.0, walls, {{{1.5, 5.0}, 2.0}, {{6.5, 5.0}, 4.0}}};
}

TEST(Statistics, FractionAndInterface) {
  EXPECT_DOUBLE_EQ(volume_fraction(two_discs(Walls::hard)), 5.0 * std::numbers::pi / 100.0);
  EXPECT_DOUBLE_EQ(specific_surface(two_discs(Walls::hard)), 6.0 * std::numbers::pi / 100.0);
}

TEST(Statistics, GapsBetweenDiscs) {
  EXPECT_DOUBLE_EQ(smallest_gap(two_discs(Walls::hard)), 2.0);
  auto periodic = two_discs(Walls::periodic);
  EXPECT_DOUBLE_EQ(smallest_gap(periodic), 2.0);
  periodic.particles[1].centre[0] = 7.5;
  EXPECT_DOUBLE_EQ(smallest_gap(periodic), 1.0);
  periodic.particles[1].centre = {9.5, 9.0};
  periodic.particles[0].centre = {1.5, 2.0};
  EXPECT_NEAR(smallest_gap(periodic), std::sqrt(4.0 + 9.0) - 3.0, 1e-14);
}

TEST(Statistics, OverlapIsANegativeGap) {
  auto discs = two_discs(Walls::hard);
  discs.particles[0].centre[0] = 4.0;
  EXPECT_DOUBLE_EQ(smallest_gap(discs), -0.5);
}

TEST(Statistics, OneDiscHasAGapOnlyToItsPeriodicImage) {
  EXPECT_EQ(smallest_gap(Microstructure<2>{10.0, Walls::hard, {{{5.0, 5.0}, 4.0}}}), no_gap);
  EXPECT_DOUBLE_EQ(smallest_gap(Microstructure<2>{10.0, Walls::periodic, {{{5.0, 5.0}, 4.0}}}), 6.0);
  EXPECT_EQ(smallest_gap(Microstructure<2>{10.0, Walls::periodic, {}}), no_gap);
}

TEST(Statistics, FarApartDiscsAreFoundToo) {
  const Microstructure<2> corners{10.0, Walls::hard, {{{0.1, 0.1}, 0.2}, {{9.9, 9.9}, 0.002}}};
  EXPECT_NEAR(smallest_gap(corners), 9.8 * std::numbers::sqrt2 - 0.101, 1e-13);
}

TEST(Statistics, GapsToTheWalls) {
  EXPECT_DOUBLE_EQ(smallest_wall_gap(two_discs(Walls::hard)), 0.5);
  EXPECT_EQ(smallest_wall_gap(two_discs(Walls::periodic)), no_gap);
  EXPECT_DOUBLE_EQ(smallest_wall_gap<2>({10.0, Walls::hard, {{{5.0, 9.5}, 2.0}}}), -0.5);
}

TEST(Statistics, HistogramIsByArea) {
  const auto discs = two_discs(Walls::hard);
  EXPECT_THAT(size_histogram(discs, std::array{1.0, 3.0, 5.0}), ElementsAre(DoubleEq(0.2), DoubleEq(0.8)));
  EXPECT_THAT(size_histogram(discs, std::array{2.0, 4.0}), ElementsAre(DoubleEq(1.0)));
  EXPECT_THAT(size_histogram(discs, std::array{1.0, 2.0, 4.0}), ElementsAre(DoubleEq(0.0), DoubleEq(1.0)));
  EXPECT_THAT(size_histogram(discs, std::array{3.0, 3.5}), ElementsAre(DoubleEq(0.0)));
}

TEST(Statistics, OfSpheres) {
  Microstructure<3> spheres = {10.0, Walls::hard, {{{1.5, 5.0, 5.0}, 2.0}, {{6.5, 5.0, 5.0}, 4.0}}};
  EXPECT_DOUBLE_EQ(volume_fraction(spheres), (4.0 / 3.0 + 32.0 / 3.0) * std::numbers::pi / 1000.0);
  EXPECT_DOUBLE_EQ(specific_surface(spheres), (4.0 + 16.0) * std::numbers::pi / 1000.0);
  EXPECT_DOUBLE_EQ(smallest_gap(spheres), 2.0);
  EXPECT_DOUBLE_EQ(smallest_wall_gap(spheres), 0.5);
  EXPECT_THAT(size_histogram(spheres, std::array{1.0, 3.0, 5.0}),
              ElementsAre(DoubleEq(1.0 / 9.0), DoubleEq(8.0 / 9.0)));
  spheres.walls = Walls::periodic;
  spheres.particles[1].centre = {9.5, 9.0, 1.0};
  spheres.particles[0].centre = {1.5, 2.0, 9.0};
  EXPECT_NEAR(smallest_gap(spheres), std::sqrt(4.0 + 9.0 + 4.0) - 3.0, 1e-14);
}

TEST(Statistics, BadEdges) {
  const auto discs = two_discs(Walls::hard);
  expect_error<InputError>([&] { return size_histogram(discs, std::array{1.0}); }, "two or more bin edges");
  expect_error<InputError>([&] { return size_histogram(discs, std::array{1.0, 1.0}); }, "rise strictly");
}

}  // namespace
}  // namespace breccia
