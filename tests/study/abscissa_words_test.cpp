#include "study/abscissa_words.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

constexpr double time_of_one_hertz = 1.0 / (2.0 * std::numbers::pi);

TEST(AbscissaWords, TellATimeOrTheFrequencyThatBelongsToIt) {
  EXPECT_EQ(display_in(Abscissa::time, 0.282), "282 ms");
  EXPECT_EQ(display_in(Abscissa::frequency, 0.282), "564 mHz");
  EXPECT_EQ(readable_in(Abscissa::time, 1e-3), "1 ms");
  EXPECT_EQ(readable_in(Abscissa::frequency, time_of_one_hertz), "1 Hz");
}

TEST(AbscissaWords, GoFromTheSmallerToTheLarger) {
  const TimeWindow window = {1e-2 * time_of_one_hertz, 10.0 * time_of_one_hertz};
  EXPECT_EQ(window_in(Abscissa::time, {1e-3, 1.0}), "from 1 ms to 1 s");
  EXPECT_EQ(window_in(Abscissa::frequency, window), "from 100 mHz to 100 Hz");
}

// 1 / (2 pi 0.1 s) is 1.5915 Hz, 1 / (2 pi 1 ms) is 159.15 Hz.
TEST(AbscissaWords, RoundFrequenciesInwards) {
  EXPECT_THAT(hertz_within({1e-3, 0.1}), testing::ElementsAre(testing::DoubleEq(1.6), testing::DoubleEq(150.0)));
}

}  // namespace
}  // namespace breccia
