#include "results/error_file.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using ::testing::HasSubstr;

StudyResult result() {
  TestResult coarse{.id = {.load = Load::shear, .boundary = Boundary::periodic, .grid = TestGrid(8)}};
  coarse.modulus = {{1.0, 3.0}, {2.0, 2.0}};
  auto limit = coarse;
  limit.id.grid = TestGrid::extrapolated();
  limit.errors = {{.grid = 0.03, .sample = 0.04, .solver = 0.0, .matrix = 0.0}, {.grid = 0.1, .solver = 1e-5}};
  StudyResult study;
  study.stages.emplace_back().name = "box";
  study.stages[0].tests = {coarse, limit};
  return study;
}

TEST(ErrorFile, HasARowForEachTimeOfThePreferredTests) {
  const test::TemporaryDirectory directory;
  const auto file = directory.path() / "errors.csv";
  write_errors(file, result());
  EXPECT_EQ(
      read_text(file),
      "stage,load,boundary,method,cells,time_s,modulus_Pa,error,grid_error,sample_error,solver_error,matrix_error\n"
      "box,shear,periodic,quasistatic,extrapolated,1,3,0.05,0.03,0.04,0,0\n"
      "box,shear,periodic,quasistatic,extrapolated,2,2,,0.1,,1e-05,\n");
}

TEST(ErrorFile, IsReadWithWhatIsNotKnown) {
  const test::TemporaryDirectory directory;
  const auto file = directory.path() / "errors.csv";
  write_errors(file, result());
  const auto table = read_error_table(file);
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_EQ(error_in(table, 0).whole(), 0.05);
  const auto second = error_in(table, 1);
  EXPECT_EQ(second.grid, 0.1);
  EXPECT_EQ(second.solver, 1e-5);
  EXPECT_FALSE(second.sample);
  EXPECT_FALSE(second.matrix);
}

TEST(ErrorFile, IsNotWrittenWithoutErrors) {
  const test::TemporaryDirectory directory;
  auto study = result();
  study.stages[0].tests[1].errors.clear();
  write_errors(directory.path() / "errors.csv", study);
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "errors.csv"));
}

TEST(ErrorFile, IsRefusedWithAnythingButANumber) {
  const test::TemporaryDirectory directory;
  directory.write("errors.csv",
                  "stage,load,boundary,method,cells,time_s,modulus_Pa,error,grid_error,sample_error,solver_error,"
                  "matrix_error\nbox,shear,periodic,quasistatic,8,1,3,,0.1x,,,\n");
  const auto table = read_error_table(directory.path() / "errors.csv");
  EXPECT_THAT(test::message_of<FileError>([&] { static_cast<void>(error_in(table, 0)); }),
              HasSubstr("errors.csv:2: not as `breccia run` writes it: grid_error is no number"));
}

}  // namespace
}  // namespace breccia
