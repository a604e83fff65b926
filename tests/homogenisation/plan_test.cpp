#include "breccia/homogenisation/plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

/// A box of 1 mm with a tenth of discs.
Study box_to_plan(int cells, std::vector<Method> methods = {Method::quasistatic}) {
  Stage stage;
  stage.name = "A";
  stage.matrix = Material{"matrix", 1e3, PronySeries(1e9), PronySeries(1e5, {{1e-2, 1e6}, {1e-3, 1e6}})};
  stage.side = 1e-3;
  stage.cells = cells;
  Filler filler;
  filler.material = {"filler", 2e3, PronySeries(1e10), PronySeries(1e10)};
  filler.fraction = 0.1;
  filler.sizes = SingleSize{1e-4};
  filler.gap = 4e-5;
  stage.fillers = {filler};
  stage.packing = LubachevskyStillingerPacking<2>{Walls::periodic, 1};
  Study study;
  study.stages = {stage};
  study.tests.boundaries = {Boundary::periodic};
  study.tests.first_time = 1e-3;
  study.tests.last_time = 1e-2;
  study.tests.methods = std::move(methods);
  return study;
}

/// A sweep over the cells and, within them, over two seeds.
Sweep sweep_over_cells(const std::vector<int>& cells, const std::vector<Method>& methods = {Method::quasistatic}) {
  Sweep sweep;
  sweep.keys = {{.path = "stages.A.cells", .label = "cells"},
                {.path = "stages.A.packing.seed", .label = "seed", .is_seed = true}};
  for (const int along_side : cells) {
    for (const int seed : {1, 2}) {
      auto& task = sweep.tasks.emplace_back();
      task.name = "cells-" + std::to_string(along_side) + "_seed-" + std::to_string(seed);
      task.values = {Scalar{std::int64_t{along_side}}, Scalar{std::int64_t{seed}}};
      task.study = box_to_plan(along_side, methods);
      task.study.stages.front().packed_by<LubachevskyStillingerPacking<2>>()->seed = static_cast<std::uint64_t>(seed);
    }
  }
  return sweep;
}

constexpr double unlimited = std::numeric_limits<double>::infinity();

std::string memory_refusal(const Study& study, double available) {
  return test::message_of<LackingMemory>([&] { require_memory(study, available); });
}

TEST(Plan, AddsTheTimesOfTestsAndHasTheMemoryOfTheLargest) {
  auto study = box_to_plan(60);
  const auto one = plan_of(study);
  study.tests.boundaries = {Boundary::periodic, Boundary::displacement};
  study.stages.front().coarser_cells = {30};
  const auto four = plan_of(study);
  ASSERT_EQ(four.stages.front().tests.size(), 4U);
  double sum = 0.0;
  for (const auto& test : four.stages.front().tests) sum += test.seconds;
  EXPECT_DOUBLE_EQ(four.seconds(), sum);
  EXPECT_EQ(four.bytes(), one.bytes());
  EXPECT_LT(four.stages.front().tests.front().bytes, four.bytes()) << "the coarser grid";
}

TEST(Plan, HasTheDomainsAndTheSpeedOfDynamicTests) {
  auto study = box_to_plan(20, {Method::dynamic});
  study.tests.loads = {Load::shear, Load::bulk};
  const auto plan = plan_of(study);
  ASSERT_EQ(plan.stages.front().tests.size(), 2U);
  const auto& test = plan.stages.front().tests.back();
  EXPECT_EQ(test.load, Load::bulk);
  EXPECT_EQ(test.unknowns, 1600.0);
  EXPECT_GT(test.speed, 0.0);
  std::int64_t steps = 0;
  for (const auto& domain : test.domains) steps += domain.steps;
  EXPECT_GT(steps, 0);
  EXPECT_DOUBLE_EQ(test.seconds, 1600.0 * static_cast<double>(steps) / test.speed);
}

// The gap of 40 um has 2.4 of 60 cells; from 1.5 cells on the error is at most 0.1 c^-1.8, or that of the interfaces.
TEST(Plan, HasTheErrorOfTheGridAndTheCellsForAnother) {
  const auto grid = plan_of(box_to_plan(60)).stages.front().grid;
  ASSERT_TRUE(grid);
  EXPECT_GE(grid->length, 4e-5);
  EXPECT_NEAR(grid->cells(), grid->length / 1e-3 * 60, 1e-9);
  const double of_gaps = 0.1 * std::pow(grid->cells(), -1.8);
  EXPECT_NEAR(grid->error().value(), std::max(of_gaps, grid->interfaces * 1e-3 / 60.0), 1e-12);
  const auto needed = grid->cells_for(0.01).value();
  EXPECT_GT(needed, 60.0);
  auto finer = *grid;
  finer.cell_size = 1e-3 / needed;
  EXPECT_LE(finer.error().value(), 0.01);
  EXPECT_FALSE(plan_of(box_to_plan(30)).stages.front().grid->error()) << "may be of any size";
}

// In this order the last tasks are the largest: all of them are planned, not the first alone.
TEST(Plan, NamesTheRangeOfTimesWhereItTakesFarLessTime) {
  auto study = box_to_plan(400);
  auto& stage = study.stages.front();
  std::get<Material>(stage.matrix).shear = PronySeries(1e4, {{1e-9, 1e9}, {1e3, 1e6}});
  study.tests.last_time = 2e-3;
  const auto remarks = [&] { return fmt::format("{}", fmt::join(plan_of(study).stages.front().remarks, "\n")); };
  EXPECT_EQ(remarks(), "") << "a run of less than two minutes";
  stage.cells = 4000;
  EXPECT_THAT(remarks(), MatchesRegex("tests.quasistatic.range = \"times\" takes some .* in place of .*"));
  study.tests.quasistatic.range = SampledRange::times;
  EXPECT_EQ(remarks(), "");
}

TEST(Plan, SaysWhereRoundingMayKeepTheToleranceFromBeingMet) {
  auto study = box_to_plan(20);
  auto& matrix = std::get<Material>(study.stages.front().matrix);
  const auto remarks = [&] { return plan_of(study).stages.front().remarks; };
  matrix.shear = PronySeries(2e2, {{1e-2, 1e6}});
  EXPECT_THAT(remarks(), testing::IsEmpty()) << "in the plane";
  study.stages.front().packing = LubachevskyStillingerPacking<3>{Walls::periodic, 1};
  matrix.shear = PronySeries(1e3, {{1e-2, 1e6}});
  EXPECT_THAT(remarks(), testing::IsEmpty());
  matrix.shear = PronySeries(2e2, {{1e-2, 1e6}});
  ASSERT_EQ(remarks().size(), 1U);
  EXPECT_THAT(remarks().front(), HasSubstr("a shear modulus falls to 2e-07 of the bulk modulus"));
  study.tests.quasistatic.solver = Solver::stepping;
  EXPECT_THAT(remarks(), testing::IsEmpty());
}

// Sizes of 20 to 1 with volumes that are even in log d make two stages of equal ratios, each with half of the 40 %: the
// smaller half in the space that the larger one leaves, 0.2 / 0.8, then the larger one in the whole.
TEST(Plan, AdvisesStagesForSizesThatOneBoxDoesNotResolve) {
  auto study = box_to_plan(50);
  auto& stage = study.stages.front();
  auto& filler = stage.fillers.front();
  filler.fraction = 0.4;
  filler.gap = 1e-7;
  filler.sizes = TabulatedSizes{{}, {5e-6, 1e-4}, {0.0, 1.0}};
  stage.side = 2e-4;
  const auto remarks = [&] { return plan_of(study).stages.front().remarks; };
  ASSERT_EQ(remarks().size(), 1U);
  EXPECT_THAT(remarks().front(), HasSubstr("its sizes span 20 to 1, and the smallest particle is 1.2 cells wide"));
  EXPECT_THAT(remarks().front(), HasSubstr("5 um to 22.4 um with fraction = 0.25, then 22.4 um to 100 um with "
                                           "fraction = 0.2;"));
  filler.sizes = TabulatedSizes{{}, {1e-5, 1e-4}, {0.0, 1.0}};
  EXPECT_THAT(remarks(), testing::IsEmpty()) << "ten to one";
}

TEST(PlanOfASweep, HasAllTasks) {
  const auto sweep = sweep_over_cells({40, 80, 400});
  const auto plan = plan_of(sweep);
  ASSERT_EQ(plan.parts.size(), 3U) << "tasks that differ by seeds share a plan";
  EXPECT_THAT(plan.parts[1].tasks, testing::ElementsAre(2, 3));
  EXPECT_EQ(&plan.largest(), &plan.parts[2]);
  double sum = 0.0;
  for (const auto& task : sweep.tasks) sum += plan_of(task.study).seconds();
  EXPECT_NEAR(plan.seconds() / sum, 1.0, 1e-12);
}

TEST(PlanOfASweep, KeepsTheOthersWhereABoxCannotBePacked) {
  auto sweep = sweep_over_cells({40, 80});
  sweep.tasks[0].study.stages.front().fillers.front().gap = 5e-4;
  const auto plan = plan_of(sweep);
  ASSERT_EQ(plan.parts.size(), 3U) << "the other seed has a box of its own";
  EXPECT_THAT(plan.parts[0].tasks, testing::ElementsAre(0));
  EXPECT_THAT(plan.parts[0].failure, HasSubstr("a gap of 500 um"));
  EXPECT_THAT(plan.parts[1].tasks, testing::ElementsAre(1));
  EXPECT_EQ(plan.parts[1].failure, "");
  EXPECT_GT(plan.parts[1].plan.bytes(), 0.0);
  EXPECT_THAT(plan.parts[2].tasks, testing::ElementsAre(2, 3));
}

TEST(RequiredMemory, IsLackingFromOneByteTooFewOn) {
  const auto study = box_to_plan(100);
  const double bytes = plan_of(study).bytes();
  EXPECT_NO_THROW(require_memory(study, bytes));
  EXPECT_THAT(memory_refusal(study, bytes - 1.0), HasSubstr("cells = 99 would fit"));
  EXPECT_THAT(memory_refusal(study, 1e-6 * bytes), Not(HasSubstr("would fit"))) << "no grid of a single cell";
}

TEST(RequiredMemory, IsToldWithTheCellsThatWouldFit) {
  const auto large = box_to_plan(2000), small = box_to_plan(100, {Method::quasistatic, Method::dynamic});
  EXPECT_NO_THROW(require_memory(small, unlimited));
  EXPECT_THAT(memory_refusal(large, 4e8),
              MatchesRegex("A: 2000 x 2000 cells take about .* GB by the quasi-static method, and "
                           "0.4 GB are left; cells = [67][0-9][0-9] would fit"));
  EXPECT_THAT(memory_refusal(small, 1e6), MatchesRegex("A: 100 x 100 .* quasi-static method.*\nA: 100 x 100 .* dynamic "
                                                       "method.*"));
  EXPECT_THAT(memory_refusal(small, -1.0), Not(HasSubstr("would fit")));
}

/// The memory [B] from which on a study is not refused.
double required_memory(const Study& study) {
  double too_little = 1.0, enough = 1e13;
  while (enough / too_little > 1.0001) {
    const double middle = std::sqrt(too_little * enough);
    try {
      require_memory(study, middle);
      enough = middle;
    } catch (const LackingMemory&) {
      too_little = middle;
    }
  }
  return enough;
}

// A fourth of the points takes a fourth of the memory of an explicit run without the program itself.
TEST(RequiredMemory, OfTheDynamicMethodGrowsWithThePoints) {
  const double small = required_memory(box_to_plan(1000, {Method::dynamic})),
               middle = required_memory(box_to_plan(2000, {Method::dynamic})),
               large = required_memory(box_to_plan(4000, {Method::dynamic}));
  EXPECT_NEAR((large - middle) / (middle - small), 4.0, 0.1);
}

// A grid of 1.7e10 cells does not fit into any memory: the estimate must not make it.
TEST(RequiredMemory, OfTheDynamicMethodIsFoundWithoutItsGrid) {
  EXPECT_THAT(memory_refusal(box_to_plan(1 << 17, {Method::dynamic}), 1e9),
              HasSubstr("A: 131072 x 131072 cells take about "));
}

// The memory has 18 numbers for each cell of a cube and term of the matrix, 7 for each node, and the phases of the
// points: 25.6 GB.
TEST(RequiredMemory, OfTheDynamicMethodInCubesIsThatOfItsHistories) {
  auto study = box_to_plan(400, {Method::dynamic});
  study.stages.front().packing = PackingMethod<3>();
  EXPECT_THAT(memory_refusal(study, 1e9), MatchesRegex("A: 400 x 400 x 400 cells take about 25.[67] GB by the dynamic "
                                                       "method, and 1 GB are left; cells = 13[0-9] would fit"));
}

// A test with mass scaling factors that are never valid has no plan; the memory of the other tests is checked all the
// same.
TEST(RequiredMemory, DoesNotTakeAPlanOfTimeDomains) {
  auto study = box_to_plan(4000, {Method::dynamic, Method::quasistatic});
  study.tests.dynamic.mass_scaling_factors = {1e12};
  auto small = study;
  small.stages.front().cells = 20;
  EXPECT_THROW(static_cast<void>(plan_of(small)), NumericalError);
  EXPECT_THAT(memory_refusal(study, 1e8), MatchesRegex("A: .* dynamic method.*\nA: .* quasi-static method.*"));
}

// A former bug: a sweep whose last tasks do not fit into the memory was accepted.
TEST(RequiredMemory, OfASweepIsThatOfAllTasks) {
  const auto sweep = sweep_over_cells({40, 4000});
  EXPECT_NO_THROW(require_memory(sweep, unlimited));
  EXPECT_THAT(test::message_of<LackingMemory>([&] { require_memory(sweep, 1e9); }),
              MatchesRegex("cells-4000_seed-1 and 1 more: A: 4000 x 4000 cells take about .*"));
  EXPECT_NO_THROW(require_memory(sweep, {0, 1}, 1e9)) << "of these tasks alone";
}

TEST(MemoryOfProcesses, IsTheirPartAndThatOfTheProgram) {
  const double alone = 1e9;
  EXPECT_EQ(memory_of_process(alone, 1), alone);
  EXPECT_GT(memory_of_process(alone, 4), alone / 4.0);
  EXPECT_LT(memory_of_process(alone, 8), memory_of_process(alone, 4));
}

}  // namespace
}  // namespace breccia
