#include "results/sweep_result.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/results/curves.hpp"

#include "messages.hpp"
#include "results/hand_made_results.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Optional;

const TestId shear{Load::shear, Boundary::displacement, Method::quasistatic, TestGrid(12)};

/// The test with one of its four parts replaced.
TestId with(TestId test, Boundary boundary) {
  test.boundary = boundary;
  return test;
}
TestId with(TestId test, Load load) {
  test.load = load;
  return test;
}
TestId with(TestId test, Method method) {
  test.method = method;
  return test;
}
TestId with(TestId test, TestGrid grid) {
  test.grid = grid;
  return test;
}

TaskResult done(std::vector<TaskCurve> curves) {
  return {.state = TaskState::done, .curves = std::move(curves)};
}

std::vector<double> first_moduli(const TaskResult& task) {
  std::vector<double> moduli;
  for (const auto& curve : task.curves) moduli.push_back(curve.modulus.at(0).modulus);
  return moduli;
}

TEST(TaskCurves, AreReadAsTheyWereWritten) {
  const StudyResult result{
      {test::stage_with("A", {test::test_with(shear, {{1e-3, 1.0 / 3.0}, {1.0, 0.1}}),
                              test::test_with(with(shear, TestGrid::extrapolated()), {{1.0, 0.2}})}),
       test::stage_with("B",
                        {test::test_with(with(with(shear, Load::diagonal_shear), Method::dynamic), {{2.0, 0.3}})})},
      {}};
  const test::TemporaryDirectory directory;
  write_curves(directory.path(), result);
  const auto written = curves_of(result), read = read_curves(directory.path());
  ASSERT_EQ(read.size(), 3U);
  ASSERT_EQ(written.size(), 3U);
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_TRUE(read[i].matches(written[i])) << i;
    EXPECT_EQ(read[i].modulus, written[i].modulus) << i;
  }
  EXPECT_EQ(read[0].modulus, (Curve{{1e-3, 1.0 / 3.0}, {1.0, 0.1}}));
}

// The whole error is the root of the sum of the squares of its causes.
TEST(TaskCurves, HaveTheErrorsOfTheirTimes) {
  const std::string of_test = "A,shear,periodic,quasistatic,12,";
  const std::string head =
      "stage,load,boundary,method,cells,time_s,modulus_Pa,error,grid_error,sample_error,solver_error,"
      "matrix_error\n";
  const auto first = of_test + "1,2e6,0.05,0.03,0.04,0,0\n", second = of_test + "10,1e6,,0.03,,0,0\n";
  const test::TemporaryDirectory directory;
  directory.write("curves.csv",
                  "stage,load,boundary,method,cells,time_s,modulus_Pa\n" + of_test + "1,2e6\n" + of_test + "10,1e6\n");
  const auto read = [&] { return read_task_curves(directory.path(), Abscissa::time); };
  EXPECT_THAT(read().at(0).errors, IsEmpty()) << "an earlier version wrote none";
  directory.write("errors.csv", head + first + second);
  const auto curve = read().at(0);
  EXPECT_THAT(curve.errors, ElementsAre(Optional(DoubleNear(0.05, 1e-15)), std::nullopt));
  EXPECT_EQ(curve.error_at(2.0), curve.errors[0]) << "nearest in the logarithm";
  EXPECT_EQ(curve.error_at(5.0), std::nullopt);
  for (const auto& rows :
       {first, second, fmt::format("{}{}", second, first), fmt::format("{}{}{}", first, second, second)}) {
    directory.write("errors.csv", head + rows);
    EXPECT_THROW(static_cast<void>(read()), FileError) << rows;
  }
}

TEST(TaskCurves, MatchByStageAndTest) {
  const TaskCurve curve{"A", shear, {{1.0, 1.0}}};
  EXPECT_TRUE(curve.matches({"A", shear, {{2.0, 5.0}}}));
  EXPECT_FALSE(curve.matches({"B", shear, {}}));
  EXPECT_FALSE(curve.matches({"A", with(shear, Load::bulk), {}}));
  EXPECT_FALSE(curve.matches({"A", with(shear, Boundary::traction), {}}));
  EXPECT_FALSE(curve.matches({"A", with(shear, Method::dynamic), {}}));
  EXPECT_FALSE(curve.matches({"A", with(shear, TestGrid(13)), {}}));
}

TEST(TaskCurves, AreRefusedFromATableThatIsDamaged) {
  const test::TemporaryDirectory directory;
  EXPECT_THROW(static_cast<void>(read_curves(directory.path())), FileError) << "no table";
  directory.write("curves.csv", "stage,load,boundary,method,cells,time_s\nA,shear,traction,quasistatic,12,1\n");
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(read_curves(directory.path())); }),
              HasSubstr("modulus_Pa"));
  for (const auto* row : {"A,tension,traction,quasistatic,12,1,1", "A,shear,free,quasistatic,12,1,1",
                          "A,shear,traction,static,12,1,1", "A,shear,traction,quasistatic,-3,1,1"}) {
    directory.write("curves.csv", std::string("stage,load,boundary,method,cells,time_s,modulus_Pa\n") + row + "\n");
    EXPECT_THAT(test::message_of<FileError>([&] { static_cast<void>(read_curves(directory.path())); }),
                HasSubstr("curves.csv:2: not as `breccia run` writes it"))
        << row;
  }
}

TEST(StageOfSweep, HasOneCurveForEachBoundary) {
  const SweepResult result = {done({{"A", with(shear, Load::bulk), {{1.0, 9.0}}},
                                    {"A", with(shear, Method::dynamic), {{1.0, 1.0}}},
                                    {"A", shear, {{1.0, 2.0}}},
                                    {"A", with(shear, TestGrid::extrapolated()), {{1.0, 3.0}}},
                                    {"A", with(shear, TestGrid(24)), {{1.0, 4.0}}},
                                    {"A", with(shear, Boundary::traction), {{1.0, 5.0}}},
                                    {"B", shear, {{1.0, 6.0}}}}),
                              done({{"B", shear, {{1.0, 7.0}}}}),
                              {}};
  const auto of_a = stage_of(result, "A");
  ASSERT_EQ(of_a.size(), 3U);
  EXPECT_THAT(first_moduli(of_a[0]), ElementsAre(3.0, 5.0)) << "shear, and the limit before the grids";
  EXPECT_THAT(first_moduli(of_a[1]), IsEmpty());
  EXPECT_EQ(of_a[2].state, TaskState::waiting);
  const auto of_last = last_stage_of(result);
  EXPECT_THAT(first_moduli(of_last[0]), ElementsAre(6.0));
  EXPECT_THAT(first_moduli(of_last[1]), ElementsAre(7.0));
}

TEST(StageOfSweep, HasTheOtherLoadWithoutShear) {
  const SweepResult result = {
      done({{"A", with(shear, Load::bulk), {{1.0, 1.0}}}, {"A", with(shear, Load::diagonal_shear), {{1.0, 2.0}}}})};
  EXPECT_THAT(first_moduli(stage_of(result, "A")[0]), ElementsAre(2.0)) << "a shear before bulk";
}

TEST(StageOfSweep, NamesTheStagesInTheirOrder) {
  const SweepResult result = {
      {}, done({{"B", shear, {}}, {"A", shear, {}}}), done({{"A", shear, {}}, {"C", shear, {}}})};
  EXPECT_THAT(tested_stages(result), ElementsAre("B", "A", "C"));
}

}  // namespace
}  // namespace breccia
