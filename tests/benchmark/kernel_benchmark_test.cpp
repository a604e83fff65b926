#include "benchmark/kernel_benchmark.hpp"

#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

using testing::Each;
using testing::Gt;
using testing::SizeIs;

TEST(KernelTiming, TakesTheMedian) {
  KernelTiming timing;
  timing.bytes_per_point_and_step = 10.0;
  timing.speeds = {5e6, 1e6, 3e6};
  EXPECT_EQ(timing.speed(), 3e6);
  EXPECT_EQ(timing.bandwidth(), 3e7);
  timing.speeds = {5e6, 1e6, 3e6, 2e6};
  EXPECT_EQ(timing.speed(), 2.5e6);
}

TEST(BenchmarkResult, ComparesWithTheBandwidthOfAsManyThreads) {
  KernelTiming timing;
  timing.kernel.threads = 2;
  timing.bytes_per_point_and_step = 10.0;
  timing.speeds = {3e6};
  BenchmarkResult result;
  result.bandwidths = {{.threads = 1, .rounds = {{.triad = 1e7, .update = 2e7}}},
                       {.threads = 2, .rounds = {{.triad = 6e7, .update = 5e7}}}};
  EXPECT_DOUBLE_EQ(result.bandwidth_share(timing), 0.5);
}

TEST(RunBenchmark, MeasuresEveryCaseInEveryRound) {
  BenchmarkPlan plan;
  plan.seconds = 0.01;
  plan.rounds = 3;
  for (const int terms : {0, 2}) {
    plan.cases.push_back({.cells = 16, .terms = terms});
    plan.cases.push_back({.formulation = Formulation::classical, .cells = 16, .terms = terms, .threads = 2});
  }
  std::vector<double> shares;
  const auto result = run_benchmark(plan, [&](double share) { shares.push_back(share); });
  ASSERT_THAT(result.kernels, SizeIs(4));
  for (const auto& timing : result.kernels) {
    EXPECT_EQ(timing.points, 4 * 16 * 16);
    EXPECT_THAT(timing.speeds, SizeIs(3));
    EXPECT_THAT(timing.speeds, Each(Gt(0.0)));
    EXPECT_GT(timing.bytes_per_point, 0.0);
  }
  EXPECT_GT(result.kernels[2].bytes_per_point, result.kernels[0].bytes_per_point);
  EXPECT_GT(result.kernels[3].bytes_per_point_and_step, result.kernels[1].bytes_per_point_and_step);
  ASSERT_THAT(result.bandwidths, SizeIs(2));
  for (const auto& timing : result.bandwidths) {
    EXPECT_THAT(timing.rounds, SizeIs(3));
    EXPECT_GT(timing.highest(), 0.0);
  }
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_DOUBLE_EQ(shares.back(), 1.0);
}

TEST(RunBenchmark, RefusesAnEmptyPlan) {
  EXPECT_THROW(run_benchmark({}), InputError);
  EXPECT_THROW(run_benchmark({.cases = {{.cells = 16}}, .rounds = 0}), InputError);
  EXPECT_THROW(run_benchmark({.cases = {{.cells = 16, .dimensions = 4}}}), InputError);
  EXPECT_THROW(run_benchmark({.cases = {{.cells = 16}}, .seconds = 0.0}), InputError);
}

}  // namespace
}  // namespace breccia
