#include "results/sweep_spread.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/hand_made_sweep.hpp"

namespace breccia {
namespace {

using test::done_with;
using testing::DoubleNear;
using testing::IsEmpty;

// The means are 3 and 20, the squares of the deviations from them 4 + 1 + 9 and 100 + 0 + 100.
TEST(SpreadOverSeeds, IsTakenOverTasksThatDifferInTheirSeedsAlone) {
  const auto curves = spread_over_seeds(test::seeds_and_gaps(),
                                        {done_with({{1.0, 1.0}}), done_with({{1.0, 10.0}}), done_with({{1.0, 2.0}}),
                                         done_with({{1.0, 20.0}}), done_with({{1.0, 6.0}}), done_with({{1.0, 30.0}})});
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].first_task, 0U);
  EXPECT_EQ(curves[1].first_task, 1U);
  EXPECT_EQ(curves[0].test.stage, "A");
  EXPECT_THAT(curves[0].test.modulus, IsEmpty());
  ASSERT_EQ(curves[0].in_time.size(), 1U);
  EXPECT_EQ(curves[0].in_time.front().time, 1.0);
  const auto& narrow = curves[0].in_time.front().modulus;
  EXPECT_EQ(narrow.tasks, 3U);
  EXPECT_EQ(narrow.mean, 3.0);
  EXPECT_THAT(narrow.standard_deviation, DoubleNear(std::sqrt(14.0 / 2.0), 1e-14));
  EXPECT_EQ(narrow.smallest, 1.0);
  EXPECT_EQ(narrow.largest, 6.0);
  const auto& wide = curves[1].in_time.at(0).modulus;
  EXPECT_EQ(wide.mean, 20.0);
  EXPECT_THAT(wide.standard_deviation, DoubleNear(10.0, 1e-14));
}

TEST(SpreadOverSeeds, IsTakenAtTimesThatSeveralTasksHave) {
  const TaskResult waiting, failed{.state = TaskState::failed, .error = "jammed"};
  const auto curves =
      spread_over_seeds(test::seeds_and_gaps(), {done_with({{0.5, 9.0}, {1.0, 4.0}}), waiting, failed, waiting,
                                                 done_with({{1.0, 2.0}, {2.0, 1.0}}), done_with({{1.0, 7.0}})});
  ASSERT_EQ(curves.size(), 1U) << "the other gap has one task";
  ASSERT_EQ(curves[0].in_time.size(), 1U);
  EXPECT_EQ(curves[0].in_time[0].time, 1.0);
  EXPECT_EQ(curves[0].in_time[0].modulus.tasks, 2U);
  EXPECT_EQ(curves[0].in_time[0].modulus.mean, 3.0);
  EXPECT_THAT(curves[0].in_time[0].modulus.standard_deviation, DoubleNear(std::sqrt(2.0), 1e-14));
}

TEST(SpreadOverSeeds, IsThatOfOneTestOfOneStage) {
  auto sweep = test::seeds_and_gaps();
  sweep.tasks.resize(4);
  const auto lower = done_with({{1.0, 4.0}}, {.boundary = Boundary::traction, .grid = TestGrid(12)});
  auto elsewhere = done_with({{1.0, 4.0}});
  elsewhere.curves[0].stage = "B";
  EXPECT_THAT(spread_over_seeds(sweep, {done_with({{1.0, 1.0}}), {}, lower, {}}), IsEmpty());
  EXPECT_THAT(spread_over_seeds(sweep, {done_with({{1.0, 1.0}}), {}, elsewhere, {}}), IsEmpty());
}

// 3 + 4i and 12 + 5i have the absolute values 5 and 13.
TEST(SpreadOverSeeds, IsThatOfTheAbsoluteValueAndThePhaseInFrequency) {
  auto sweep = test::seeds_and_gaps();
  auto one = done_with({{1.0, 1.0}}), other = one;
  one.curves[0].in_frequency = {{2.0, 3.0, 4.0}, {7.0, 1.0, 1.0}};
  other.curves[0].in_frequency = {{2.0, 12.0, 5.0}};
  const auto curves = spread_over_seeds(sweep, {one, {}, other, {}, {}, {}});
  ASSERT_EQ(curves.size(), 1U);
  ASSERT_EQ(curves[0].in_frequency.size(), 1U) << "one task alone has the other frequency";
  const auto& [frequency, absolute, phase] = curves[0].in_frequency[0];
  EXPECT_EQ(frequency, 2.0);
  EXPECT_EQ(absolute.tasks, 2U);
  EXPECT_EQ(absolute.mean, 9.0);
  EXPECT_THAT(absolute.standard_deviation, DoubleNear(4.0 * std::sqrt(2.0), 1e-14));
  EXPECT_THAT(phase.smallest, DoubleNear(std::atan(5.0 / 12.0), 1e-15));
  EXPECT_THAT(phase.largest, DoubleNear(std::atan(4.0 / 3.0), 1e-15));
}

TEST(SpreadOverSeeds, IsNoneWithoutASeed) {
  auto sweep = test::seeds_and_gaps();
  sweep.keys[0].is_seed = false;
  EXPECT_THAT(spread_over_seeds(sweep, SweepResult(6, done_with({{1.0, 1.0}}))), IsEmpty());
}

TEST(SweepTasks, AreNamedWithoutTheirSeeds) {
  auto sweep = test::seeds_and_gaps();
  EXPECT_EQ(name_without_seeds(sweep, sweep.tasks[1]), "gap-2 um");
  sweep.keys[1].is_seed = true;
  EXPECT_EQ(name_without_seeds(sweep, sweep.tasks[1]), "");
  sweep.keys[0].is_seed = sweep.keys[1].is_seed = false;
  EXPECT_EQ(name_without_seeds(sweep, sweep.tasks[1]), "seed-1_gap-2 um");
}

TEST(SweepTasks, DifferInSomeKeysOnly) {
  const auto sweep = test::seeds_and_gaps();
  const auto is_gap = [](const SweptKey& key) { return key.label == "gap"; };
  EXPECT_TRUE(differ_only_in(sweep, sweep.tasks[0], sweep.tasks[1], is_gap));
  EXPECT_FALSE(differ_only_in(sweep, sweep.tasks[0], sweep.tasks[2], is_gap)) << "another seed";
  EXPECT_TRUE(differ_only_in(sweep, sweep.tasks[0], sweep.tasks[0], is_gap)) << "no difference is one in nothing else";
  EXPECT_TRUE(differ_only_in(sweep, sweep.tasks[0], sweep.tasks[3], [](const SweptKey&) { return true; }));
}

}  // namespace
}  // namespace breccia
