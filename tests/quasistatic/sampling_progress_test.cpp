#include "quasistatic/reduced/sampling_progress.hpp"

#include <cmath>
#include <cstddef>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia::quasistatic {
namespace {

// An error that falls tenfold with each snapshot meets 1e-5 with the fifth.
TEST(SamplingProgress, IsTheShareOfTheSolutionsToBeExpected) {
  SamplingProgress progress({.tolerance = 1e-5}, 1);
  for (int snapshots = 1; snapshots < 5; ++snapshots) {
    const auto now = progress.after(snapshots, std::pow(10.0, -snapshots));
    EXPECT_NEAR(now.share, snapshots / 5.0, 1e-12);
  }
}

TEST(SamplingProgress, NeitherFallsNorStaysAtNothing) {
  SamplingProgress progress({.tolerance = 1e-5, .most_snapshots = 24}, 5);
  double last = 0.0;
  for (int snapshots = 0; snapshots < 24; ++snapshots) {
    for (std::size_t load = 0; load < 5; ++load) {
      for (int iteration = 1; iteration <= 2; ++iteration) {
        const auto now = progress.within_solution(snapshots, load);
        EXPECT_GE(now.share, last);
        EXPECT_LT(now.share, 1.0);
        last = now.share;
      }
    }
    last = progress.after(snapshots + 1, snapshots < 3 ? 1.0 : snapshots % 2 == 0 ? 0.5 : 1e-4).share;
    EXPECT_GE(last, snapshots / 24.0);
  }
}

TEST(SamplingProgress, TellsTheLoadTheIterationAndTheErrorThatIsKnown) {
  SamplingProgress progress({}, 2);
  EXPECT_EQ(progress.within_solution(0, 0).details, "snapshot 1, load 1 of 2, iteration 1");
  EXPECT_EQ(progress.within_solution(0, 0).details, "snapshot 1, load 1 of 2, iteration 2");
  EXPECT_EQ(progress.within_solution(0, 1).details, "snapshot 1, load 2 of 2, iteration 1");
  EXPECT_EQ(progress.after(1, 1.0).details, "snapshot 1");
  EXPECT_EQ(progress.after(4, 1e-3).details, "snapshot 4, error 1e-03");
  EXPECT_EQ(SamplingProgress({}, 1).within_solution(3, 0).details, "snapshot 4, iteration 1");
}

}  // namespace
}  // namespace breccia::quasistatic
