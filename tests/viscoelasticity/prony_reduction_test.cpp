#include "viscoelasticity/prony_reduction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "binder.hpp"

namespace breccia {
namespace {

double largest_deviation_between(const PronySeries& one, const PronySeries& other, const TimeWindow& window) {
  double largest = 0.0;
  constexpr double step = 1.011;
  for (double t = window.begin; t < window.end; t *= step) {
    largest = std::max(largest, std::abs(one.at(t) / other.at(t) - 1.0));
  }
  return largest;
}

TEST(PronyReduction, StaysWithinTheToleranceBetweenTheSamples) {
  const TimeWindow window = {1e-9, 1e2};
  const std::vector<PronySeries> given = {binder};
  std::size_t terms = 1000;
  for (const double tolerance : {0.001, 0.01, 0.05}) {
    const auto reduction = reduce_prony(given, window, {.tolerance = tolerance});
    const double found = largest_deviation_between(reduction.series[0], binder, window);
    EXPECT_LE(reduction.worst_deviation(), tolerance);
    EXPECT_NEAR(found, reduction.worst_deviation(), 0.02 * tolerance);
    EXPECT_LE(reduction.relaxation_times(), terms);
    terms = reduction.relaxation_times();
  }
  // The binder itself has 13 terms that matter in the window: one a decade from 0.15 ns to 150 s.
  EXPECT_LE(terms, 13U);
}

TEST(PronyReduction, GivesCommonRelaxationTimes) {
  const PronySeries other(1e9, {{1e-6, 1e8}, {1e-3, 5e8}, {1.0, 2e8}});
  const std::vector<PronySeries> given = {binder, other};
  const TimeWindow window = {1e-8, 1e1};
  const auto reduction = reduce_prony(given, window);
  EXPECT_LE(largest_deviation_between(reduction.series[0], binder, window), 0.0101);
  EXPECT_LE(largest_deviation_between(reduction.series[1], other, window), 0.0101);
  const auto most = std::max(reduction.series[0].terms().size(), reduction.series[1].terms().size());
  EXPECT_LT(reduction.relaxation_times(), reduction.series[0].terms().size() + reduction.series[1].terms().size());
  EXPECT_LE(reduction.relaxation_times(), most + 3);
}

TEST(PronyReduction, MakesAModulusElasticThatHardlyChanges) {
  const std::vector<PronySeries> given = {PronySeries(1e9, {{1e-3, 4e6}})};
  const auto reduction = reduce_prony(given, {1e-6, 1.0});
  EXPECT_TRUE(reduction.series[0].is_elastic());
  EXPECT_NEAR(reduction.deviations[0], 0.002, 1e-5);
}

TEST(PronyReduction, OfADifferenceHasNoNegativeTerms) {
  // 5 + exp(-t / 1) - 0.5 exp(-t / 0.1) would rise at first; with a slower decay it only falls.
  const auto difference =
      PronySeries::difference(PronySeries(5.0, {{1.0, 1.0}, {0.5, 2.0}}), PronySeries(0.0, {{0.4, 0.2}}));
  const std::vector<PronySeries> given = {difference};
  const auto reduction = reduce_prony(given, {1e-2, 1e1});
  EXPECT_LE(reduction.worst_deviation(), 0.01);
  for (const auto& term : reduction.series[0].terms()) EXPECT_GT(term.modulus, 0.0);
}

TEST(PronyReduction, OfARisingModulusDeviates) {
  const auto rising = PronySeries::difference(PronySeries(5.0), PronySeries(0.0, {{1.0, 1.0}}));
  const std::vector<PronySeries> given = {rising};
  const auto reduction = reduce_prony(given, {1e-2, 1e1});
  EXPECT_GT(reduction.worst_deviation(), 0.05);  // a constant between 4 and 5 is the best
}

TEST(PronyReduction, KeepsToTheMostTerms) {
  const std::vector<PronySeries> given = {binder};
  const auto reduction = reduce_prony(given, {1e-9, 1e2}, {.tolerance = 1e-6, .most_terms = 10});
  EXPECT_LE(reduction.relaxation_times(), 10U);
  EXPECT_GT(reduction.worst_deviation(), 1e-6);
  EXPECT_LT(reduction.worst_deviation(),
            0.2);  // the binder has 13 terms there, one a decade, on which its modulus ripples
}

/// A series with terms at equal distances in decades from 1 ns, as a measured binder has, and the window of its
/// decades.
std::pair<PronySeries, TimeWindow> lines(int terms, int decades_apart) {
  std::vector<MaxwellTerm> all;
  for (int i = 0; i < terms; ++i) {
    const int decade = -9 + decades_apart * i;
    all.push_back({std::pow(10.0, decade), 1.23456e6 * std::pow(10.0, -0.25 * decade)});
  }
  return {PronySeries(1.2345e3, all), {1e-9, std::pow(10.0, -9 + decades_apart * terms)}};
}

TEST(PronyReduction, HasNoMoreTermsThanTheSeriesItself) {
  for (const auto& [terms, decades_apart] : {std::pair{5, 1}, {5, 2}, {10, 1}, {13, 1}}) {
    const auto [series, window] = lines(terms, decades_apart);
    const std::vector<PronySeries> given = {series, PronySeries(2.1e9)};
    std::size_t fewer = 0;
    for (const double tolerance : {0.05, 0.01, 0.001, 1e-6}) {
      const auto reduction = reduce_prony(given, window, {.tolerance = tolerance});
      EXPECT_LE(reduction.relaxation_times(), static_cast<std::size_t>(terms)) << tolerance;
      EXPECT_GE(reduction.relaxation_times(), fewer) << tolerance;
      EXPECT_LE(reduction.worst_deviation(), tolerance);
      fewer = reduction.relaxation_times();
    }
  }
}

TEST(PronyReduction, KeepsTheSeriesRatherThanDeviate) {
  const auto [series, window] = lines(10, 1);
  const std::vector<PronySeries> given = {series};
  const auto reduction = reduce_prony(given, window, {.tolerance = 1e-13, .most_terms = 10});
  EXPECT_EQ(reduction.series[0], series);
  EXPECT_EQ(reduction.worst_deviation(), 0.0);
}

TEST(PronyReduction, HasNoMoreTermsForAWiderTolerance) {
  // Three moduli that become elastic one after the other; the last one has a negative term, but falls.
  const std::vector<PronySeries> given = {
      binder, PronySeries(5e9, {{1e-7, 3e8}, {3e-5, 1e8}, {1e-2, 5e7}}),
      PronySeries::difference(PronySeries(8e9, {{1e-6, 2e8}, {1e-2, 2e8}}), PronySeries(0.0, {{1e-3, 1e7}}))};
  std::size_t fewer = 1000;
  for (const double tolerance : {5e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.04, 0.08, 0.15, 0.2}) {
    const auto reduction = reduce_prony(given, {1e-8, 1e-2}, {.tolerance = tolerance});
    EXPECT_LE(reduction.worst_deviation(), tolerance);
    EXPECT_LE(reduction.relaxation_times(), fewer) << tolerance;
    fewer = reduction.relaxation_times();
  }
  EXPECT_LE(fewer, 6U);
}

/// A term every decade makes the modulus ripple by less than one per cent about a smooth one, which takes fewer terms.
TEST(PronyReduction, HasFewerTermsThanTheBinder) {
  const std::vector<PronySeries> given = {binder};
  const auto reduction = reduce_prony(given, {1e-8, 1e-2});
  EXPECT_LE(reduction.worst_deviation(), 0.01);
  EXPECT_LE(reduction.relaxation_times(), 7U);  // from 1.5e-9 to 1.5e-2 s the binder has 8
}

TEST(PronyReduction, RefusesNonsense) {
  const std::vector<PronySeries> given = {binder};
  EXPECT_THROW(static_cast<void>(reduce_prony(given, {1.0, 1.0})), InputError);
  EXPECT_THROW(static_cast<void>(reduce_prony(given, {1.0, 2.0}, {.tolerance = 0.0})), InputError);
  const std::vector<PronySeries> nothing = {PronySeries(0.0)};
  EXPECT_THROW(static_cast<void>(reduce_prony(nothing, {1.0, 2.0})), InputError);
}

}  // namespace
}  // namespace breccia
