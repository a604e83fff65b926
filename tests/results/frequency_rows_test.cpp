#include "breccia/results/frequency_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

constexpr double per_cycle = 2.0 * std::numbers::pi;

TEST(FrequencyRows, AreThoseOfTheTimes) {
  const Curve curve = {{1e-3, 3.0}, {2e-2, 2.0}, {5.0, 1.0}};
  EXPECT_THAT(FrequencyRows::of(Tests{}).of(curve), ::testing::ElementsAre(1.0 / 5.0, 1.0 / 2e-2, 1.0 / 1e-3));
}

TEST(FrequencyRows, AreWholePartsOfDecadesInHertz) {
  Tests tests;
  tests.by_frequency = true;
  tests.points_per_decade = 4;
  // The curve is from 0.3 to 100 Hz, by the times 1 / (2 pi f).
  const Curve curve = {{1.0 / (per_cycle * 100.0), 3.0}, {1e-2, 2.0}, {1.0 / (per_cycle * 0.3), 1.0}};
  std::vector<double> hertz;
  for (const double frequency : FrequencyRows::of(tests).of(curve)) hertz.push_back(frequency / per_cycle);
  std::vector<double> expected = {0.3};
  for (int k = -2; k <= 8; ++k) expected.push_back(std::pow(10.0, 0.25 * k));
  ASSERT_EQ(hertz.size(), expected.size());
  for (std::size_t i = 0; i < hertz.size(); ++i) EXPECT_NEAR(hertz[i] / expected[i], 1.0, 1e-15);
  EXPECT_TRUE(std::ranges::is_sorted(hertz));
}

}  // namespace
}  // namespace breccia
