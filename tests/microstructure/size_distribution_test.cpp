#include "breccia/microstructure/size_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/draw_diameters.hpp"

#include "expect_error.hpp"
#include "hmx_sizes.hpp"
#include "test_names.hpp"

namespace breccia {
namespace {

using test::expect_error;
using test::hmx;

constexpr double infinity = std::numeric_limits<double>::infinity();

SizeDistribution sieves() {
  return SizeDistribution::tabulated({1e-6, 10e-6, 100e-6}, {0.0, 0.4, 1.0});
}

double normal_cumulative(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

TEST(SizeDistribution, MonodisperseIsAStep) {
  const auto sizes = SizeDistribution::monodisperse(5e-6);
  EXPECT_EQ(sizes.cumulative(4.999e-6), 0.0);
  EXPECT_EQ(sizes.cumulative(5e-6), 1.0);
  EXPECT_EQ(sizes.quantile(0.0), 5e-6);
  EXPECT_EQ(sizes.quantile(0.5), 5e-6);
  EXPECT_EQ(sizes.quantile(1.0), 5e-6);
}

TEST(SizeDistribution, LognormalHasItsMedianAndItsSigma) {
  const auto sizes = SizeDistribution::lognormal_mixture({{1.0, 20e-6, 0.5}});
  EXPECT_DOUBLE_EQ(sizes.cumulative(20e-6), 0.5);
  EXPECT_NEAR(sizes.cumulative(20e-6 * std::exp(0.5)), 0.8413447460685429, 1e-15);
  EXPECT_NEAR(sizes.quantile(0.5), 20e-6, 1e-20);
  EXPECT_EQ(sizes.smallest(), 0.0);
  EXPECT_EQ(sizes.largest(), infinity);
  EXPECT_EQ(sizes.quantile(1.0), infinity);
}

TEST(SizeDistribution, MixtureWeightsAreNormalised) {
  const auto expected = [](double d) {
    return 0.75 * normal_cumulative(std::log(d / 154e-6) / 0.76) +
           0.25 * normal_cumulative(std::log(d / 12.7e-6) / 1.09);
  };
  for (const double d : {1e-6, 14e-6, 100e-6, 1e-3}) EXPECT_NEAR(hmx().cumulative(d), expected(d), 1e-15);
}

TEST(SizeDistribution, ReferenceMixtureMeetsTheSharesOfTheThreeStages) {
  // the volume-weighted distribution fixed by the stages' fractions: F(14 um) = 0.123, F(100 um) = 0.446
  const auto above_2_um = hmx().truncated(2e-6, 1.0);
  EXPECT_NEAR(above_2_um.cumulative(14e-6), 0.123, 0.01);
  EXPECT_NEAR(above_2_um.cumulative(100e-6), 0.446, 0.01);
}

TEST(SizeDistribution, TableIsLinearInLogDiameter) {
  EXPECT_EQ(sieves().cumulative(0.5e-6), 0.0);
  EXPECT_EQ(sieves().cumulative(1e-6), 0.0);
  EXPECT_DOUBLE_EQ(sieves().cumulative(10e-6), 0.4);
  EXPECT_NEAR(sieves().cumulative(std::sqrt(10.0) * 10e-6), 0.7, 1e-15);
  EXPECT_EQ(sieves().cumulative(200e-6), 1.0);
  EXPECT_NEAR(sieves().quantile(0.2), std::sqrt(10.0) * 1e-6, 1e-20);
}

TEST(SizeDistribution, QuantileOfAPlateauIsItsLowerEnd) {
  const auto sizes = SizeDistribution::tabulated({1e-6, 2e-6, 4e-6, 8e-6}, {0.0, 0.5, 0.5, 1.0});
  EXPECT_NEAR(sizes.quantile(0.5), 2e-6, 1e-20);
}

TEST(SizeDistribution, TruncationRescales) {
  const auto sizes = hmx().truncated(14e-6, 100e-6);
  const double below = hmx().cumulative(14e-6);
  const double within = hmx().cumulative(100e-6) - below;
  for (const double d : {20e-6, 50e-6, 99e-6}) {
    EXPECT_NEAR(sizes.cumulative(d), (hmx().cumulative(d) - below) / within, 1e-13);
  }
  EXPECT_EQ(sizes.cumulative(13.9e-6), 0.0);
  EXPECT_EQ(sizes.cumulative(100e-6), 1.0);
  EXPECT_EQ(sizes.quantile(0.0), 14e-6);
  EXPECT_EQ(sizes.quantile(1.0), 100e-6);
}

TEST(SizeDistribution, TruncationsNest) {
  const auto twice = hmx().truncated(1e-6, 50e-6).truncated(10e-6, 200e-6);
  const auto once = hmx().truncated(10e-6, 50e-6);
  EXPECT_EQ(twice.smallest(), 10e-6);
  EXPECT_EQ(twice.largest(), 50e-6);
  EXPECT_NEAR(twice.cumulative(25e-6), once.cumulative(25e-6), 1e-14);
}

TEST(SizeDistribution, QuantileInvertsTheCumulative) {
  for (const auto& sizes : {hmx(), hmx().truncated(2e-6, 14e-6), sieves(), sieves().truncated(5e-6, 20e-6)}) {
    for (const double p : {1e-6, 0.01, 0.3, 0.5, 0.77, 0.999})
      EXPECT_NEAR(sizes.cumulative(sizes.quantile(p)), p, 1e-12);
  }
}

TEST(SizeDistribution, BadArguments) {
  expect_error<InputError>([] { return SizeDistribution::monodisperse(-1e-6); }, "diameter", "-1e-06 m");
  expect_error<InputError>([] { return SizeDistribution::monodisperse(std::nan("")); }, "nan");
  expect_error<InputError>([] { return SizeDistribution::lognormal_mixture({}); }, "at least one component");
  expect_error<InputError>([] { return SizeDistribution::lognormal_mixture({{-1.0, 1e-6, 1.0}}); }, "weight", "-1");
  expect_error<InputError>(
      [] {
        return SizeDistribution::lognormal_mixture({{0.0, 1e-6, 1.0}});
      },
      "sum of the weights");
  expect_error<InputError>([] { return SizeDistribution::lognormal_mixture({{1.0, 0.0, 1.0}}); }, "median");
  expect_error<InputError>([] { return SizeDistribution::lognormal_mixture({{1.0, 1e-6, 0.0}}); }, "sigma");
  expect_error<InputError>([] { return SizeDistribution::tabulated({1e-6}, {1.0}); }, "at least two", "1 and 1");
  expect_error<InputError>([] { return SizeDistribution::tabulated({1e-6, 2e-6}, {0.0}); }, "2 and 1");
  expect_error<InputError>([] { return SizeDistribution::tabulated({2e-6, 2e-6}, {0.0, 1.0}); }, "rise strictly");
  expect_error<InputError>(
      [] {
        return SizeDistribution::tabulated({1e-6, 2e-6, 3e-6}, {0.0, 0.6, 0.5});
      },
      "must not fall", "0.5", "0.6");
  expect_error<InputError>([] { return SizeDistribution::tabulated({1e-6, 2e-6}, {0.0, 100.0}); }, "end at 1", "100");
  expect_error<InputError>([] { return sieves().truncated(20e-6, 10e-6); }, "below the first");
  expect_error<InputError>([] { return sieves().truncated(-1e-6, 10e-6); }, "negative");
  expect_error<InputError>([] { return sieves().truncated(200e-6, 300e-6); }, "nothing of it", "0.0002 m", "0.0003 m");
  expect_error<InputError>([] { return hmx().truncated(1.0, 2.0); }, "nothing of it");
  expect_error<InputError>([] { return sieves().quantile(1.1); }, "from 0 to 1", "1.1");
}

TEST(DrawDiametersOfSpheres, FillTheirShareOfACube) {
  constexpr double side = 1e-4, diameter = 10e-6;
  const auto diameters = draw_diameters<3>(SizeDistribution::monodisperse(diameter), 0.3, side);
  // Whole spheres of pi d^3 / 6 each.
  EXPECT_EQ(diameters.size(), static_cast<std::size_t>(std::lround(0.3 * 6000.0 / std::numbers::pi)));
  // The smaller of two spheres of 1 and 2 um has a ninth of the volume.
  const auto one_size = SizeDistribution::monodisperse(1e-6);
  EXPECT_DOUBLE_EQ(largest_deviation<3>(one_size, std::vector{2e-6, 1e-6}), 8.0 / 9.0);
}

double disc_area(double diameter) {
  return std::numbers::pi / 4.0 * diameter * diameter;
}

double total_area(const std::vector<double>& diameters) {
  return std::accumulate(diameters.begin(), diameters.end(), 0.0,
                         [](double area, double diameter) { return area + disc_area(diameter); });
}

struct Draw {
  SizeDistribution sizes;
  double fraction;
  double side;

  friend std::ostream& operator<<(std::ostream& out, const Draw& draw) {
    return out << draw.fraction << " of " << draw.side << " m, " << draw.sizes.smallest() << " m to "
               << draw.sizes.largest() << " m";
  }
};

class DrawDiameters : public ::testing::TestWithParam<Draw> {};

TEST_P(DrawDiameters, MeetsTheDistributionWithinOneDisc) {
  const auto& [sizes, fraction, side] = GetParam();
  const auto diameters = draw_diameters<2>(sizes, fraction, side);
  ASSERT_FALSE(diameters.empty());
  EXPECT_TRUE(std::ranges::is_sorted(diameters, std::ranges::greater{}));
  EXPECT_LE(diameters.front(), sizes.largest());
  EXPECT_GE(diameters.back(), sizes.smallest());
  const double area = total_area(diameters);
  EXPECT_NEAR(area, fraction * side * side, disc_area(diameters.back()));
  EXPECT_LE(largest_deviation<2>(sizes, diameters), disc_area(diameters.front()) / area);
}

TEST_P(DrawDiameters, IsTheSameEveryTime) {
  const auto& [sizes, fraction, side] = GetParam();
  EXPECT_EQ(draw_diameters<2>(sizes, fraction, side), draw_diameters<2>(sizes, fraction, side));
}

INSTANTIATE_TEST_SUITE_P(Distributions, DrawDiameters,
                         ::testing::Values(Draw{hmx().truncated(2e-6, 14e-6), 0.65, 48e-6},
                                           Draw{hmx().truncated(14e-6, 100e-6), 0.63, 420e-6},
                                           Draw{hmx().truncated(100e-6, 600e-6), 0.52, 2.75e-3},
                                           Draw{hmx().truncated(1e-6, 100e-6), 0.85, 1e-3}, Draw{sieves(), 0.7, 500e-6},
                                           Draw{SizeDistribution::monodisperse(3e-6), 0.6, 100e-6}),
                         test::by_value);

TEST(DrawDiameters, MonodisperseIsRoundedToTheNearestNumber) {
  const double side = 100e-6;
  for (const double count : {1.0, 17.4, 17.6, 300.49}) {
    const auto sizes = SizeDistribution::monodisperse(4e-6);
    const auto diameters = draw_diameters<2>(sizes, count * disc_area(4e-6) / (side * side), side);
    EXPECT_EQ(diameters, std::vector<double>(static_cast<std::size_t>(std::lround(count)), 4e-6));
  }
}

TEST(DrawDiameters, EachDiscIsAtTheMiddleOfItsSlice) {
  const double side = 48e-6;
  const double fraction = 0.65;
  const auto sizes = hmx().truncated(2e-6, 14e-6);
  double above = 0.0;
  for (const double diameter : draw_diameters<2>(sizes, fraction, side)) {
    EXPECT_NEAR(sizes.cumulative(diameter), 1.0 - (above + 0.5 * disc_area(diameter)) / (fraction * side * side),
                1e-12);
    above += disc_area(diameter);
  }
}

TEST(DrawDiameters, BadArguments) {
  const auto sizes = SizeDistribution::monodisperse(4e-6);
  expect_error<InputError>([&] { return draw_diameters<2>(sizes, 0.0, 1e-3); }, "between 0 and 1", "got 0");
  expect_error<InputError>([&] { return draw_diameters<2>(sizes, 1.0, 1e-3); }, "between 0 and 1");
  expect_error<InputError>([&] { return draw_diameters<2>(sizes, 0.5, -1e-3); }, "side", "-0.001 m");
  expect_error<NumericalError>([&] { return draw_diameters<2>(sizes, 0.1, 5e-6); }, "less than half a particle");
  expect_error<NumericalError>([&] { return draw_diameters<2>(sizes, 0.5, 1e-2); }, "more than 1000000 particles");
  expect_error<InputError>([&] { return draw_diameters<2>(hmx(), 0.5, 1e-3); }, "truncate it", "inf m");
}

TEST(LargestDeviation, OfKnownDraws) {
  // one disc of 10 um for the whole table: F(10 um) = 0.4 below the step, 1 - 0.4 above it
  EXPECT_NEAR(largest_deviation<2>(sieves(), std::vector{10e-6}), 0.6, 1e-12);
  // one disc for half of the area each, the step in the right place
  const auto sizes = SizeDistribution::monodisperse(1e-6);
  EXPECT_EQ(largest_deviation<2>(sizes, std::vector{1e-6, 1e-6}), 0.0);
  EXPECT_EQ(largest_deviation<2>(sizes, std::vector{2e-6, 1e-6}), 0.8);
}

}  // namespace
}  // namespace breccia
