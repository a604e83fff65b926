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
  ASSERT_EQ(curves[0].spreads.size(), 1U);
  const auto& narrow = curves[0].spreads.front();
  EXPECT_EQ(narrow.time, 1.0);
  EXPECT_EQ(narrow.tasks, 3U);
  EXPECT_EQ(narrow.mean, 3.0);
  EXPECT_THAT(narrow.standard_deviation, DoubleNear(std::sqrt(14.0 / 2.0), 1e-14));
  EXPECT_EQ(narrow.smallest, 1.0);
  EXPECT_EQ(narrow.largest, 6.0);
  const auto& wide = curves[1].spreads.at(0);
  EXPECT_EQ(wide.mean, 20.0);
  EXPECT_THAT(wide.standard_deviation, DoubleNear(10.0, 1e-14));
}

TEST(SpreadOverSeeds, IsTakenAtTimesThatSeveralTasksHave) {
  const TaskResult waiting, failed{.state = TaskState::failed, .error = "jammed"};
  const auto curves =
      spread_over_seeds(test::seeds_and_gaps(), {done_with({{0.5, 9.0}, {1.0, 4.0}}), waiting, failed, waiting,
                                                 done_with({{1.0, 2.0}, {2.0, 1.0}}), done_with({{1.0, 7.0}})});
  ASSERT_EQ(curves.size(), 1U) << "the other gap has one task";
  ASSERT_EQ(curves[0].spreads.size(), 1U);
  EXPECT_EQ(curves[0].spreads[0].time, 1.0);
  EXPECT_EQ(curves[0].spreads[0].tasks, 2U);
  EXPECT_EQ(curves[0].spreads[0].mean, 3.0);
  EXPECT_THAT(curves[0].spreads[0].standard_deviation, DoubleNear(std::sqrt(2.0), 1e-14));
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
