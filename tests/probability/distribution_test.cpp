#include "breccia/probability/distribution.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// Quantiles of the standard normal distribution: Abramowitz and Stegun, Handbook of Mathematical Functions, Table 26.5,
// and of the tail from its continued fraction.
TEST(NormalScore, IsTheQuantileOfTheTable) {
  EXPECT_NEAR(normal_score(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_score(0.5), 0.0, 1e-15);
  EXPECT_NEAR(normal_score(0.1), -1.281551565544601, 1e-14);
  EXPECT_NEAR(normal_score(1e-9), -5.997807015007687, 1e-13);
  EXPECT_EQ(normal_score(0.0), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(normal_score(1.0), std::numeric_limits<double>::infinity());
}

TEST(NormalScore, InvertsTheShareIntoTheFarTail) {
  for (const double score : {-37.0, -12.0, -3.0, -0.2, 0.4, 2.0, 5.0}) {
    EXPECT_NEAR(normal_score(normal_share(score)), score, 1e-9 * (1.0 + std::abs(score))) << score;
  }
}

// Abramowitz and Stegun, Table 26.10.
TEST(StudentScore, IsTheQuantileOfTheTable) {
  EXPECT_NEAR(student_score(0.975, 3.0) / 3.182, 1.0, 0.01);
  EXPECT_NEAR(student_score(0.975, 5.0) / 2.571, 1.0, 0.002);
  EXPECT_NEAR(student_score(0.975, 15.0) / 2.131, 1.0, 5e-4);
  EXPECT_NEAR(student_score(0.975, 1e9), normal_score(0.975), 1e-8);
}

TEST(Distribution, HasTheValuesOfItsScores) {
  EXPECT_NEAR(value_at_score(Normal{3.0, 0.5}, 2.0), 4.0, 1e-15);
  EXPECT_NEAR(value_at_score(LogNormal{2.0, 3.0}, -1.0), 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(value_at_score(Uniform{1.0, 5.0}, 0.0), 3.0, 1e-15);
  EXPECT_NEAR(value_at_score(Uniform{1.0, 5.0}, normal_score(0.25)), 2.0, 1e-14);
  EXPECT_NEAR(value_at_score(LogUniform{1.0, 100.0}, 0.0), 10.0, 1e-14);
  EXPECT_NEAR(median(LogUniform{1e-3, 1e-1}), 1e-2, 1e-16);
}

TEST(Distribution, FindsTheScoreOfAValue) {
  const std::vector<Distribution> all = {Normal{3.0, 0.5}, LogNormal{2.0, 3.0}, Uniform{1.0, 5.0},
                                         LogUniform{1.0, 100.0}};
  for (const auto& one : all) {
    for (const double score : {-2.5, -0.3, 0.0, 1.7}) {
      EXPECT_NEAR(score_of(one, value_at_score(one, score)), score, 1e-12) << one.index();
    }
  }
  EXPECT_EQ(score_of(Uniform{1.0, 5.0}, 7.0), std::numeric_limits<double>::infinity());
}

TEST(Distribution, NamesItsMistake) {
  EXPECT_THAT(mistake_in(Normal{1.0, 0.0}), HasSubstr("expected a positive standard deviation, got 0"));
  EXPECT_THAT(mistake_in(LogNormal{1.0, 1.0}), HasSubstr("expected a factor above 1, got 1"));
  EXPECT_THAT(mistake_in(LogNormal{-1.0, 2.0}), HasSubstr("expected a positive value with a factor, got -1"));
  EXPECT_THAT(mistake_in(Uniform{2.0, 1.0}), HasSubstr("expected two rising values, got 2 and 1"));
  EXPECT_THAT(mistake_in(LogUniform{0.0, 1.0}), HasSubstr("expected positive values of a logarithmic range, got 0"));
  EXPECT_THAT(mistake_in(LogUniform{1.0, 2.0}), IsEmpty());
}

}  // namespace
}  // namespace breccia
