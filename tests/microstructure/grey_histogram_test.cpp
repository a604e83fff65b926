#include "microstructure/image/grey_histogram.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;
using Values = std::vector<std::int32_t>;

/// Sum of the squared deviations of the values from first to last from their mean.
double scatter(const Values& values, std::int32_t first, std::int32_t last) {
  double sum = 0.0, count = 0.0, squares = 0.0;
  for (const auto value : values) {
    if (value < first || value > last) continue;
    sum += value;
    count += 1.0;
  }
  for (const auto value : values) {
    if (value >= first && value <= last) squares += std::pow(value - sum / count, 2);
  }
  return squares;
}

/// The threshold with the least variance within the two sides, which is that of the largest one between them.
std::int32_t threshold_of_least_scatter(const Values& values, std::int32_t darkest, std::int32_t brightest) {
  double least = std::numeric_limits<double>::infinity();
  auto best = darkest;
  for (auto threshold = darkest; threshold < brightest; ++threshold) {
    const double within = scatter(values, darkest, threshold) + scatter(values, threshold + 1, brightest);
    if (within < least * (1.0 - 1e-12)) {
      least = within;
      best = threshold;
    }
  }
  return best;
}

TEST(GreyHistogram, HasTheThresholdWithTheLeastScatterWithinBothSides) {
  std::mt19937_64 random(3);
  for (const double share : {0.5, 0.3, 0.1}) {
    Values values;
    for (int pixel = 0; pixel < 500; ++pixel) {
      const double mean = static_cast<double>(random() % 1000) < 1000.0 * share ? 150.0 : 70.0;
      values.push_back(static_cast<std::int32_t>(mean + static_cast<double>(random() % 61) - 30.0));
    }
    const GreyHistogram histogram(values);
    const auto threshold = threshold_of_least_scatter(values, histogram.darkest(), histogram.brightest());
    EXPECT_EQ(histogram.divided_at(histogram.otsu_threshold()).dark, histogram.divided_at(threshold).dark) << share;
    const double within =
        scatter(values, histogram.darkest(), threshold) + scatter(values, threshold + 1, histogram.brightest());
    EXPECT_NEAR(histogram.divided_at(threshold).separability,
                1.0 - within / scatter(values, histogram.darkest(), histogram.brightest()), 1e-12);
  }
}

TEST(GreyHistogram, OfTwoValuesIsSeparatedWhollyInTheirMiddle) {
  const GreyHistogram histogram(Values{-10, -10, -10, 30});
  EXPECT_EQ(histogram.otsu_threshold(), 9.5) << "the middle of -10 to 29, which all part them";
  const auto made = histogram.divided_at(-10);
  EXPECT_DOUBLE_EQ(made.separability, 1.0);
  EXPECT_DOUBLE_EQ(made.dark.share, 0.75);
  EXPECT_EQ(made.bright, (GreySide{.darkest = 30, .brightest = 30, .mean = 30.0, .share = 0.25}));
  EXPECT_DOUBLE_EQ(made.margin, 4.0);
  EXPECT_EQ(made.bright_at_lower, 1.0);
  EXPECT_EQ(made.bright_at_higher, 0.25);
}

TEST(GreyHistogram, HasSidesWithTheirRangesAndMeans) {
  const auto made = GreyHistogram(Values{1, 2, 2, 7, 8, 12}).divided_at(6.5);
  EXPECT_EQ(made.dark.darkest, 1);
  EXPECT_EQ(made.dark.brightest, 2);
  EXPECT_DOUBLE_EQ(made.dark.mean, 5.0 / 3.0);
  EXPECT_EQ(made.dark.share, 0.5);
  EXPECT_EQ(made.bright, (GreySide{.darkest = 7, .brightest = 12, .mean = 9.0, .share = 0.5}));
}

// n equal bins: the variance between the halves is n^2/16, that of all is (n^2 - 1)/12.
TEST(GreyHistogram, ThatIsFlatHasASeparabilityOfThreeQuarters) {
  Values values;
  for (int value = 0; value < 100; ++value) values.push_back(value);
  const GreyHistogram histogram(values);
  EXPECT_EQ(histogram.otsu_threshold(), 49);
  EXPECT_NEAR(histogram.divided_at(49).separability, 625.0 / (9999.0 / 12.0), 1e-12);
  EXPECT_NEAR(separability_of_flat_histogram, 625.0 / (9999.0 / 12.0), 1e-4);
}

TEST(GreyHistogram, OfANormalDistributionHasASeparabilityOfTwoOverPi) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(1000.0, 100.0);
  Values values;
  for (int pixel = 0; pixel < 200000; ++pixel) values.push_back(static_cast<std::int32_t>(normal(random)));
  const GreyHistogram histogram(values);
  EXPECT_NEAR(histogram.divided_at(histogram.otsu_threshold()).separability, 2.0 / std::numbers::pi, 5e-3);
}

TEST(GreyHistogram, RefusesWhatNoThresholdDivides) {
  expect_error<InputError>(
      [] {
        static_cast<void>(GreyHistogram(Values{5, 5}).otsu_threshold());
      },
      "all pixels have the grey value 5");
  expect_error<InputError>(
      [] {
        GreyHistogram(Values{0, 65536});
      },
      "grey values from 0 to 65536; expected at most 65536");
  const GreyHistogram histogram(Values{10, 20});
  for (const double threshold : {9.9, 20.0}) {
    expect_error<InputError>([&] { static_cast<void>(histogram.divided_at(threshold)); },
                             "expected a threshold from 10 to below 20, the darkest and the brightest grey value, got");
  }
}

}  // namespace
}  // namespace breccia
