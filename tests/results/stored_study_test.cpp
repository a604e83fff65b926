#include "results/stored_study.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "results/hand_made_documents.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using ::testing::HasSubstr;

/// A directory of one stage with tests on two grids, written by hand.
class StoredStudyTest : public testing::Test {
 protected:
  StoredStudyTest() {
    write_record("box");
    directory.write("curves.csv",
                    "stage,load,boundary,method,cells,time_s,modulus_Pa\n"
                    "box,shear,traction,quasistatic,8,1,4\nbox,shear,traction,quasistatic,8,2,3\n"
                    "box,shear,traction,quasistatic,16,1,2\nbox,shear,traction,quasistatic,16,2,1\n");
    directory.write("prony.csv",
                    "stage,load,boundary,relaxation_time_s,modulus_Pa\nbox,shear,traction,inf,1\n"
                    "box,shear,traction,3,2\n");
  }
  void write_record(const std::string& stage) const {
    const auto test_on = [](int cells, double error, double seconds) {
      TestEntry test{.id = {Load::shear, Boundary::traction, Method::quasistatic, TestGrid(cells)}};
      test.record = QuasistaticEntry{.error_estimate = error, .seconds = seconds};
      return test;
    };
    auto document = test::document_with(stage, {test_on(8, 1e-4, 0.5), test_on(16, 2e-4, 1.0)});
    document.seconds = 1.5;
    document.materials = {{"binder", 1000.0, PronySeries(2e9), PronySeries(1.0), {}}};
    auto& entry = document.stages.front();
    entry.grids = {TestGrid(8), TestGrid(16)};
    entry.points = 1024;
    entry.point_fraction = 0.25;
    entry.warnings = {"doubt"};
    entry.quality = {.summary = "grid: error up to 2 %", .grids = 2, .grid_error = 0.02};
    write_study_document(directory.path(), document);
  }
  [[nodiscard]] std::string refusal() const {
    return test::message_of<FileError>([&] { static_cast<void>(read_stored_study(directory.path())); });
  }

  test::TemporaryDirectory directory;
};

TEST_F(StoredStudyTest, HasCurvesRecordsAndTheSeriesOfThePreferredTest) {
  const auto study = read_stored_study(directory.path());
  EXPECT_EQ(study.content.title, "t");
  EXPECT_EQ(study.seconds, 1.5);
  ASSERT_EQ(study.stages.size(), 1U);
  const auto& stage = study.stages.front();
  EXPECT_EQ(stage.cells, 16);
  EXPECT_EQ(stage.points, 1024U);
  EXPECT_EQ(stage.warnings, std::vector<std::string>{"doubt"});
  EXPECT_EQ(stage.accuracy.summary, "grid: error up to 2 %");
  EXPECT_EQ(stage.accuracy.grid_error, 0.02);
  EXPECT_FALSE(stage.accuracy.rules.one_grid);
  ASSERT_EQ(stage.tests.size(), 2U);
  EXPECT_EQ(stage.tests[0].modulus, (Curve{{1.0, 4.0}, {2.0, 3.0}}));
  EXPECT_EQ(stage.tests[1].error_estimate, 2e-4);
  EXPECT_EQ(stage.tests[1].seconds, 1.0);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(stage.tests[1].record)) << "how it was computed is not read";
  EXPECT_EQ(stage.tests[0].series, PronySeries()) << "prony.csv has those of the finest grid alone";
  EXPECT_EQ(stage.tests[1].series, PronySeries(1.0, {{3.0, 2.0}}));
  EXPECT_TRUE(study.responses.empty());
}

TEST_F(StoredStudyTest, HasTheErrorsOfTheModuli) {
  const std::string head =
      "stage,load,boundary,method,cells,time_s,modulus_Pa,error,grid_error,sample_error,solver_error,matrix_error\n";
  const std::string first = "box,shear,traction,quasistatic,16,1,2,0.05,0.03,0.04,0,0\n";
  directory.write("errors.csv", head + first + "box,shear,traction,quasistatic,16,2,1,,0.03,,0,0\n");
  const auto study = read_stored_study(directory.path());
  EXPECT_TRUE(study.stages.at(0).tests.at(0).errors.empty());
  ASSERT_EQ(study.stages[0].tests.at(1).errors.size(), 2U);
  EXPECT_EQ(study.stages[0].tests[1].errors[0].whole(), 0.05);
  EXPECT_FALSE(study.stages[0].tests[1].errors[1].sample);
  directory.write("errors.csv", head + first);
  EXPECT_THAT(refusal(), HasSubstr("errors.csv: not as `breccia run` writes it: not an error for each row"));
}

TEST_F(StoredStudyTest, ATableOfAnotherStudyIsRefused) {
  directory.write("compliance.csv",
                  "stage,load,boundary,method,cells,time_s,compliance_1_per_Pa\n"
                  "box,shear,traction,quasistatic,12,1,0.5\n");
  EXPECT_THAT(refusal(), HasSubstr("compliance.csv:2: not as `breccia run` writes it: curves.csv has no such test"));
  directory.write("compliance.csv",
                  "stage,load,boundary,method,cells,time_s,compliance_1_per_Pa\n"
                  "box,shear,above,quasistatic,8,1,0.5\n");
  EXPECT_THAT(refusal(), HasSubstr("compliance.csv:2: not as `breccia run` writes it"));
  write_record("other");
  EXPECT_THAT(refusal(), HasSubstr("curves.csv: not as `breccia run` writes it: a stage that study.json has not"));
}

TEST_F(StoredStudyTest, NamesThatLeadOutOfTheResultsAreRefused) {
  write_record("../box");
  EXPECT_THAT(refusal(), HasSubstr("\"../box\" is not a name that `breccia run` gives"));
}

}  // namespace
}  // namespace breccia
