#include "virtual_test/stitching.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

/// A domain whose history is `scale` times t^-1/2.
TimeDomain domain(TimeWindow window, double scale) {
  TimeDomain domain;
  domain.window = window;
  for (double t = 0.5 * window.begin; t < 2.0 * window.end; t *= 1.004) {
    domain.history.push_back({t, scale / std::sqrt(t)});
  }
  return domain;
}

TEST(Stitch, FollowsTheOnlyValidDomainAndBlendsWhereTwoAre) {
  const std::vector<TimeDomain> domains = {domain({1.0, 20.0}, 1.0), domain({10.0, 100.0}, 1.02)};
  const auto curve = stitch(domains, {1.0, 100.0}, 20);
  EXPECT_DOUBLE_EQ(curve.front().time, 1.0);
  EXPECT_DOUBLE_EQ(curve.back().time, 100.0);
  for (const auto& [time, modulus] : curve) {
    const double share = std::clamp(std::log(time / 10.0) / std::log(2.0), 0.0, 1.0);
    EXPECT_NEAR(modulus * std::sqrt(time), 1.0 + 0.02 * share, 1e-5) << "at " << time;
  }
}

TEST(Stitch, DoesNotJumpWhereThreeDomainsOverlap) {
  const auto curve =
      stitch({domain({1.0, 20.0}, 1.0), domain({5.0, 60.0}, 1.02), domain({10.0, 100.0}, 1.04)}, {1.0, 100.0}, 2000);
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double before = curve[i - 1].modulus * std::sqrt(curve[i - 1].time);
    EXPECT_NEAR(curve[i].modulus * std::sqrt(curve[i].time), before, 1e-4) << "at " << curve[i].time;
  }
  EXPECT_NEAR(curve.back().modulus * 10.0, 1.04, 1e-5);
}

TEST(Stitch, RefusesAGap) {
  EXPECT_THROW(stitch({domain({1.0, 9.0}, 1.0), domain({10.0, 100.0}, 1.0)}, {1.0, 100.0}, 20), NumericalError);
}

TEST(CompareOverlaps, FindsTheMismatch) {
  const auto overlaps = compare_overlaps({domain({1.0, 20.0}, 1.0), domain({10.0, 100.0}, 1.02)}, 20);
  ASSERT_EQ(overlaps.size(), 1U);
  EXPECT_EQ(overlaps[0].window, (TimeWindow{10.0, 20.0}));
  EXPECT_NEAR(overlaps[0].mismatch, 0.02, 1e-5);
}

TEST(CompareOverlaps, ExpectsAnOverlap) {
  EXPECT_TRUE(compare_overlaps({domain({1.0, 9.0}, 1.0), domain({10.0, 100.0}, 1.0)}, 20).empty());
}

}  // namespace
}  // namespace breccia
