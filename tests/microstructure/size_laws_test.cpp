#include "breccia/microstructure/size_laws.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/microstructure/size_distribution.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;

constexpr std::array shares = {0.001, 0.1, 0.3, 0.5, 0.63, 0.9, 0.999};

/// Expects the share below and the quantiles of a distribution, and both of a part of it, to be those of a closed form.
template <class Share, class Quantile>
void expect_law(const SizeDistribution& sizes, const Share& share, const Quantile& quantile) {
  for (const double p : shares) {
    EXPECT_NEAR(sizes.quantile(p) / quantile(p), 1.0, 1e-12) << p;
    EXPECT_NEAR(sizes.cumulative(quantile(p)), p, 1e-14);
    EXPECT_NEAR(share(quantile(p)), p, 1e-14) << "the closed form itself";
  }
  const double from = quantile(0.2), to = quantile(0.8);
  const auto part = sizes.truncated(from, to);
  EXPECT_EQ(part.smallest(), from);
  EXPECT_EQ(part.largest(), to);
  for (const double p : shares) {
    EXPECT_NEAR(part.quantile(p) / quantile(0.2 + 0.6 * p), 1.0, 1e-12) << p;
    EXPECT_NEAR(part.cumulative(quantile(0.2 + 0.6 * p)), p, 1e-13);
  }
}

TEST(FullerSizes, ArePowersOfTheDiameter) {
  for (const double exponent : {0.45, 0.5, 1.0}) {
    const auto sizes = SizeDistribution::fuller({16e-3, exponent});
    expect_law(
        sizes, [&](double d) { return std::pow(d / 16e-3, exponent); },
        [&](double p) { return 16e-3 * std::pow(p, 1.0 / exponent); });
    EXPECT_EQ(sizes.largest(), 16e-3);
    EXPECT_EQ(sizes.smallest(), 0.0);
    EXPECT_EQ(sizes.cumulative(20e-3), 1.0);
  }
  EXPECT_DOUBLE_EQ(SizeDistribution::fuller({16e-3}).cumulative(4e-3), 0.5) << "the square root, unless said otherwise";
}

TEST(RosinRammlerSizes, AreAnExponentialOfAPower) {
  for (const double exponent : {0.8, 1.2, 3.0}) {
    const auto sizes = SizeDistribution::rosin_rammler({120e-6, exponent});
    expect_law(
        sizes, [&](double d) { return 1.0 - std::exp(-std::pow(d / 120e-6, exponent)); },
        [&](double p) { return 120e-6 * std::pow(-std::log1p(-p), 1.0 / exponent); });
    EXPECT_NEAR(sizes.cumulative(120e-6), 1.0 - 1.0 / std::numbers::e, 1e-15);
    EXPECT_EQ(sizes.largest(), std::numeric_limits<double>::infinity());
  }
}

TEST(QuantileSizes, AreLognormalWhereTheMedianIsTheGeometricMean) {
  const auto quantiles = SizeDistribution::quantiles({30e-6, 120e-6, 480e-6});
  const auto lognormal = SizeDistribution::lognormal_mixture({{1.0, 120e-6, std::log(4.0) / 1.2815515655446004}});
  expect_law(
      quantiles, [&](double d) { return lognormal.cumulative(d); }, [&](double p) { return lognormal.quantile(p); });
}

TEST(QuantileSizes, HaveTheirQuantilesAndTwoWidths) {
  const auto sizes = SizeDistribution::quantiles({40e-6, 120e-6, 300e-6});
  EXPECT_NEAR(sizes.quantile(0.1), 40e-6, 1e-18);
  EXPECT_NEAR(sizes.quantile(0.5), 120e-6, 1e-18);
  EXPECT_NEAR(sizes.quantile(0.9), 300e-6, 1e-18);
  // Twice the distance from the median, in the logarithm of the diameter, is twice the score.
  const double two_scores = 0.5 * std::erfc(2.0 * 1.2815515655446004 / std::numbers::sqrt2);
  EXPECT_NEAR(sizes.cumulative(120e-6 * std::pow(40.0 / 120.0, 2)), two_scores, 1e-15);
  EXPECT_NEAR(sizes.cumulative(120e-6 * std::pow(300.0 / 120.0, 2)), 1.0 - two_scores, 1e-15);
}

TEST(SizeLaws, HaveNothingBelowZero) {
  for (const auto& sizes : {SizeDistribution::fuller({1e-3}), SizeDistribution::rosin_rammler({1e-3, 1.0}),
                            SizeDistribution::quantiles({1e-4, 1e-3, 1e-2})}) {
    EXPECT_EQ(sizes.cumulative(0.0), 0.0);
  }
}

TEST(SizeLaws, RefuseNumbersThatMakeNoLaw) {
  expect_error<InputError>([] { return SizeDistribution::fuller({0.0}); }, "the largest diameter of Fuller's curve");
  expect_error<InputError>([] { return SizeDistribution::fuller({1e-3, -0.5}); }, "exponent", "-0.5");
  expect_error<InputError>([] { return SizeDistribution::rosin_rammler({-1e-3, 1.0}); }, "the size", "-0.001 m");
  expect_error<InputError>([] { return SizeDistribution::rosin_rammler({1e-3, 0.0}); }, "exponent", "got 0");
  expect_error<InputError>([] { return SizeDistribution::quantiles({0.0, 1e-3, 2e-3}); }, "a quantile", "got 0 m");
  expect_error<InputError>([] { return SizeDistribution::quantiles({2e-3, 1e-3, 3e-3}); }, "must rise strictly");
}

}  // namespace
}  // namespace breccia
