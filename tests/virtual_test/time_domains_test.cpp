#include "virtual_test/time_domains.hpp"

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

/// A box of 1 m with 1 kg/m^3: at modulus G the shear wave crosses it in 1 / sqrt(G) s at mass scaling factor 1.
DomainRules unit_box(TimeWindow times, std::vector<double> factors = {}) {
  DomainRules rules;
  rules.side = 1.0;
  rules.density = 1.0;
  rules.times = times;
  rules.mass_scaling_factors = std::move(factors);
  return rules;
}

struct Visited {
  double factor;
  TimeWindow window;
};

/// Runs a sequence along a known curve.
std::vector<Visited> walk(const DomainRules& rules, const std::function<double(double)>& modulus) {
  DomainSequence sequence(rules, modulus(rules.times.begin));
  std::vector<Visited> domains;
  for (;;) {
    double t = 1e-3 * rules.times.begin;
    while (sequence.observe(t, modulus(t))) t *= 1.002;
    if (sequence.window()) domains.push_back({sequence.mass_scaling(), *sequence.window()});
    if (sequence.is_complete()) return domains;
    sequence.advance();
  }
}

const auto one = [](double) { return 1.0; };

TEST(DomainRules, ThreeThereAndBackTransitsDecide) {
  const auto rules = unit_box({1.0, 2.0});
  EXPECT_DOUBLE_EQ(rules.transit(4.0, 16.0), 0.5);
  EXPECT_DOUBLE_EQ(rules.admissible_factor(6.0, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(6.0 * rules.transit(rules.admissible_factor(0.7, 3.0), 3.0), 0.7);
}

TEST(DomainSequence, AGivenFactorIsValidAfterSixTransits) {
  const auto domains = walk(unit_box({6.1, 60.0}, {1.0}), one);
  ASSERT_EQ(domains.size(), 1U);
  EXPECT_NEAR(domains[0].window.begin, 6.0, 0.02);
  EXPECT_NEAR(domains[0].window.end, 60.0, 0.15);
}

TEST(DomainSequence, EndsADomainAfterTheRequestedOverlap) {
  const auto domains = walk(unit_box({6.1, 1000.0}, {1.0, 100.0}), one);
  ASSERT_EQ(domains.size(), 2U);
  EXPECT_NEAR(domains[1].window.begin, 60.0, 0.2);
  EXPECT_NEAR(domains[0].window.end, 90.0, 0.3);
}

TEST(DomainSequence, WithALongOverlapAllGivenFactorsRunToTheEnd) {
  auto rules = unit_box({6.1, 1000.0}, {1.0, 100.0, 1e4, 1e6});
  rules.overlap = 1e3;
  const auto domains = walk(rules, one);
  // The last factor would count from 6000 s on.
  ASSERT_EQ(domains.size(), 3U);
  for (std::size_t i = 0; i < domains.size(); ++i) {
    EXPECT_NEAR(domains[i].window.begin / std::pow(10.0, static_cast<double>(i)), 6.0, 0.02);
    EXPECT_NEAR(domains[i].window.end, 1000.0, 3.0);
  }
}

TEST(DomainSequence, ChosenFactorsCoverTheTimesWithoutAGap) {
  const auto power_law = [](double t) { return std::pow(t, -0.6); };
  const auto domains = walk(unit_box({1e-6, 1e2}), power_law);
  EXPECT_LE(domains.front().window.begin, 1e-6);
  EXPECT_GE(domains.back().window.end, 1e2);
  for (std::size_t i = 0; i + 1 < domains.size(); ++i) {
    EXPECT_NEAR(domains[i + 1].factor / domains[i].factor, 10.0, 1e-9);
    EXPECT_NEAR(domains[i].window.end / domains[i + 1].window.begin, 1.5, 0.02);
  }
}

TEST(DomainSequence, FactorsFallAgainWhereTheCompositeRelaxesFasterThanWavesCross) {
  const auto exponential = [](double t) { return std::exp(-t); };
  const auto rules = unit_box({0.5, 10.0});
  const auto domains = walk(rules, exponential);
  EXPECT_LT(domains.back().factor, domains[domains.size() - 2].factor);
  EXPECT_GE(domains.back().window.end, 10.0);
  for (const auto& domain : domains) {
    EXPECT_LE(domain.factor, 1.1 * rules.admissible_factor(domain.window.end, exponential(domain.window.end)));
  }
}

TEST(DomainSequence, FactorsRiseAgainOnAPlateau) {
  const auto fall_and_plateau = [](double t) { return std::exp(-t) + 1e-5; };
  const auto domains = walk(unit_box({0.5, 1e5}), fall_and_plateau);
  EXPECT_GT(domains.back().factor, 1e3 * domains.front().factor);
}

TEST(DomainSequence, SaysWhenAGivenFactorIsNeverValid) {
  EXPECT_THROW(walk(unit_box({6.0, 60.0}, {1e6}), one), NumericalError);
}

TEST(DomainSequence, SaysWhenTheFirstGivenFactorIsValidTooLate) {
  EXPECT_THROW(walk(unit_box({3.0, 60.0}, {1.0}), one), NumericalError);
}

TEST(DomainSequence, SaysWhenAGivenFactorExpires) {
  const auto exponential = [](double t) { return std::exp(-t); };
  EXPECT_THROW(walk(unit_box({1.0, 20.0}, {0.01}), exponential), NumericalError);
}

TEST(DomainSequence, RingingDoesNotEndAYoungWindow) {
  const auto ringing = [](double t) { return 1.0 + 0.05 * std::sin(20.0 * t); };
  EXPECT_EQ(walk(unit_box({6.5, 60.0}, {1.0}), ringing).size(), 1U);
}

}  // namespace
}  // namespace breccia
