#include "breccia/viscoelasticity/reduction.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace breccia {
namespace {

/// One term a decade over 22 decades, moduli falling with the relaxation time as in a rubbery binder.
PronySeries wide_spectrum() {
  std::vector<MaxwellTerm> terms;
  for (int k = -14; k < 8; ++k) terms.push_back({std::pow(10.0, k), 1e6 * std::pow(10.0, -0.2 * k)});
  return {0.0, terms};
}

TEST(Reduction, StaysWithinItsBoundInTheWindow) {
  const auto full = wide_spectrum();
  for (const double begin : {1e-9, 1e-6, 1e-3, 1.0}) {
    const TimeWindow window = {begin, 10.0 * begin};
    const auto reduced = reduce_to_window(full, window, 1e-2);
    EXPECT_LE(reduced.error_bound, 1e-2);
    for (double t = window.begin; t <= window.end; t *= 1.1) {
      EXPECT_NEAR(reduced.series.at(t) / full.at(t), 1.0, reduced.error_bound) << "at " << t;
    }
  }
}

TEST(Reduction, KeepsOnlyTermsNearTheWindow) {
  const auto reduced = reduce_to_window(wide_spectrum(), {1e-4, 1e-3}, 1e-2);
  EXPECT_LE(reduced.series.terms().size(), 8U);
  EXPECT_LT(reduced.series.terms().front().relaxation_time, 1e2);
  EXPECT_GT(reduced.series.terms().back().relaxation_time, 1e-9);
}

TEST(Reduction, SlowTermsBecomeSprings) {
  const auto reduced = reduce_to_window(PronySeries(1.0, {{1e9, 2.0}}), {1.0, 2.0}, 1e-3);
  EXPECT_TRUE(reduced.series.is_elastic());
  EXPECT_EQ(reduced.series.equilibrium(), 3.0);
}

TEST(Reduction, FastTermsLeaveNothing) {
  const auto reduced = reduce_to_window(PronySeries(1.0, {{1e-9, 2.0}}), {1.0, 2.0}, 1e-3);
  EXPECT_EQ(reduced.series, PronySeries(1.0));
}

TEST(Reduction, WithoutToleranceChangesNothing) {
  const auto full = wide_spectrum();
  const auto reduced = reduce_to_window(full, {1e-4, 1e-3}, 0.0);
  EXPECT_EQ(reduced.series, full);
  EXPECT_EQ(reduced.error_bound, 0.0);
}

}  // namespace
}  // namespace breccia
