#include "io/display.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace breccia {
namespace {

TEST(Display, ChoosesTheEngineeringPrefix) {
  EXPECT_EQ(display(48e-6, "m"), "48 um");
  EXPECT_EQ(display(3.6e9, "Pa"), "3.6 GPa");
  EXPECT_EQ(display(6e-3, "m"), "6 mm");
  EXPECT_EQ(display(10e-9, "s"), "10 ns");
  EXPECT_EQ(display(1.0, "s"), "1 s");
  EXPECT_EQ(display(-2500.0, "Pa"), "-2.5 kPa");
}

TEST(Display, RoundsToSignificantDigitsWithoutAnExponent) {
  EXPECT_EQ(display(943.87e6, "Pa"), "944 MPa");
  EXPECT_EQ(display(943.87e6, "Pa", 1), "900 MPa");
  EXPECT_EQ(display(943.87e6, "Pa", 5), "943.87 MPa");
}

TEST(Display, TakesTheNextPrefixWhenRoundingReachesIt) {
  EXPECT_EQ(display(999.4e-6, "m"), "999 um");
  EXPECT_EQ(display(999.96e-6, "m"), "1 mm");
  EXPECT_EQ(display(999.96e-6, "m", 5), "999.96 um");
  EXPECT_EQ(display(999.5e-6, "m"), "999 um");  // as a double it is nearer to 999
}

TEST(Display, HasAnAnswerForEveryNumber) {
  EXPECT_EQ(display(0.0, "m"), "0 m");
  EXPECT_EQ(display(std::numeric_limits<double>::infinity(), "s"), "inf s");
  EXPECT_EQ(display(std::numeric_limits<double>::quiet_NaN(), "s"), "nan s");
  EXPECT_EQ(display(1.5e-14, "s"), "15 fs");
  EXPECT_EQ(display(1.5e-20, "s"), "1.5e-20 s");
  EXPECT_EQ(display(2e16, "Pa"), "2e+16 Pa");
  EXPECT_NO_THROW(display(1e-310, "Pa"));
}

TEST(Display, GivesTheScaleOfThePrefix) {
  const auto side = with_prefix(2.75e-3);
  EXPECT_EQ(side.prefix, "m");
  EXPECT_DOUBLE_EQ(side.number, 2.75);
  EXPECT_DOUBLE_EQ(side.number * side.scale, 2.75e-3);
}

TEST(Display, TimesOfTestsAreInSeconds) {
  EXPECT_EQ(display_time(10e-9), "10 ns");
  EXPECT_EQ(display_time(0.05), "50 ms");
  EXPECT_EQ(display_time(999.6), "1000 s");
  EXPECT_EQ(display_time(1e3), "1000 s");
  EXPECT_EQ(display_time(12345.0), "12300 s");
  EXPECT_EQ(display_time(1e6), "1e6 s");
  EXPECT_EQ(display_time(2.5e7), "2.5e7 s");
  EXPECT_EQ(display_time(0.0), "0 s");
  EXPECT_EQ(display_time(std::numeric_limits<double>::infinity()), "inf s");
}

TEST(Display, TimesOfCalculationsAreInMinutesAndHours) {
  EXPECT_EQ(display_duration(0.81, 1), "800 ms");
  EXPECT_EQ(display_duration(90.0), "90 s");
  EXPECT_EQ(display_duration(3000.0, 1), "50 min");
  EXPECT_EQ(display_duration(3.0 * 3600.0), "3 h");
  EXPECT_EQ(display_duration(10.0 * 86400.0), "10 d");
}

TEST(Display, ThreeDigitsOfANumber) {
  EXPECT_EQ(three_digits(1000.0), "1000");
  EXPECT_EQ(three_digits(123456.0), "123000");
  EXPECT_EQ(three_digits(-0.0123456), "-0.0123");
  EXPECT_EQ(three_digits(1.0), "1");
}

TEST(Display, OneIsSingular) {
  EXPECT_EQ(display_count(1, "term"), "1 term");
  EXPECT_EQ(display_count(0, "term"), "0 terms");
  EXPECT_EQ(display_count(12, "term"), "12 terms");
}

TEST(Display, ANumberBesideAnotherShowsThatItIsAnother) {
  EXPECT_EQ(display_beside(2.1234, 3.0), "2.1");
  EXPECT_EQ(display_beside(2.998, 3.0), "2.998");
  EXPECT_EQ(display_beside(2.96, 3.0), "2.96");
  EXPECT_EQ(display_beside(3.0, 3.0), "3") << "the same number";
}

TEST(Display, RoundsToTwoDigitsInOneDirection) {
  EXPECT_DOUBLE_EQ(rounded_down_to_two_digits(0.2999), 0.29);
  EXPECT_DOUBLE_EQ(rounded_up_to_two_digits(0.2901), 0.30);
  for (const double two_digits : {0.29, 0.57, 1.1, 9.9, 1e-7, 3.6e9}) {
    EXPECT_DOUBLE_EQ(rounded_down_to_two_digits(two_digits), two_digits);
    EXPECT_DOUBLE_EQ(rounded_up_to_two_digits(two_digits), two_digits);
  }
}

}  // namespace
}  // namespace breccia
