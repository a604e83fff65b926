// Tests of the content of a directory of results when a run ends halfway, and of the run that resumes from it.

#include <filesystem>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/campaign/run.hpp"
#include "breccia/error.hpp"

#include "campaign/deck_study.hpp"
#include "campaign/pack.hpp"
#include "campaign/result_transaction.hpp"
#include "results/study_record.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

class InterruptedRun : public testing::Test {
 protected:
  InterruptedRun() {
    study = test::two_stages();
    study.tests.boundaries = {Boundary::displacement};
    test::give_provenance(study, "two scales");
  }
  /// Files of a directory of results, without those of plots.
  [[nodiscard]] std::vector<std::string> files(const std::string& subdirectory = ".") const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(results / subdirectory)) {
      const auto name = entry.path().filename().string();
      if (entry.is_regular_file() && !name.ends_with("modulus.svg")) names.push_back(name);
    }
    return names;
  }
  /// Runs the study until a test of a stage is done.
  void run_until_tested(const std::string& name) const {
    const auto stop = [&](const RunEvent& event) {
      const auto* tested = std::get_if<TestFinished>(&event);
      if (tested != nullptr && tested->stage.name == name) throw Interrupted("enough");
    };
    EXPECT_THROW(static_cast<void>(run_study(study, results, {}, {.event = stop})), Interrupted);
  }

  Study study;
  test::TemporaryDirectory directory;
  const fs::path results = directory.path() / "results";
};

TEST_F(InterruptedRun, LeavesNothingBeforeTheFirstPacking) {
  const auto stop = [](const Progress&) { throw Interrupted("enough"); };
  study.stages[0].packing = LubachevskyStillingerPacking<2>{};
  study.stages[0].fillers[0].fraction = 0.3;
  study.stages[0].fillers[0].sizes = SingleSize{1e-3};
  test::give_provenance(study, "random");
  EXPECT_THROW(static_cast<void>(run_study(study, results, {}, {.progress = stop})), Interrupted);
  EXPECT_FALSE(fs::exists(results));
}

TEST_F(InterruptedRun, LeavesAPackingAndItsRecord) {
  const auto stop = [](const RunEvent& event) {
    if (std::holds_alternative<StagePacked>(event)) throw Interrupted("enough");
  };
  EXPECT_THROW(static_cast<void>(run_study(study, results, {}, {.event = stop})), Interrupted);
  EXPECT_THAT(files("fine"), UnorderedElementsAre("labels.npy", "labels.vti", "microstructure.csv",
                                                  "microstructure.svg", "packing.checkpoint.h5"));
  EXPECT_FALSE(fs::exists(results / "coarse"));
  EXPECT_TRUE(read_study_record(results).is_of(study));
  EXPECT_FALSE(read_study_record(results).has_tests);
}

TEST_F(InterruptedRun, LeavesTheTestsThatAreDone) {
  run_until_tested("coarse");
  EXPECT_THAT(files("fine"), Contains("response.h5"));
  EXPECT_THAT(files("coarse"), Contains("microstructure.csv"));
  EXPECT_THAT(files("coarse"), Not(Contains("response.h5"))) << "not all loads are tested";
  const auto record = read_study_record(results);
  EXPECT_TRUE(record.has_tests);
  EXPECT_THAT(record.stages_packed, ElementsAre("fine", "coarse"));
  EXPECT_FALSE(record.is_complete_run_of(study));
}

TEST_F(InterruptedRun, GoesOnToTheSameBits) {
  const auto whole = directory.path() / "whole";
  const auto in_one_go = run_study(study, whole);
  run_until_tested("coarse");
  std::vector<std::string> packed, tested;
  const auto note = [&](const RunEvent& event) {
    if (const auto* one = std::get_if<TestFinished>(&event)) tested.push_back(one->stage.name);
  };
  const auto resumed = run_study(study, results, {.resume = true}, {.event = note});
  EXPECT_THAT(tested, ElementsAre("fine", "fine", "coarse")) << "those that were done are told again";
  EXPECT_TRUE(resumed.seconds);
  for (const auto* table : {"curves.csv", "dynamic.csv", "engineering.csv", "errors.csv", "prony.csv", "quality.csv"}) {
    EXPECT_EQ(read_text(results / table), read_text(whole / table)) << table;
  }
  EXPECT_TRUE(read_study_record(results).is_complete_run_of(study));
  EXPECT_THAT(files("fine"), UnorderedElementsAre("labels.npy", "labels.vti", "microstructure.csv",
                                                  "microstructure.svg", "response.h5"))
      << "without checkpoints";
  EXPECT_THAT(files(), UnorderedElementsAre("study.json", "report.html", "checksums.txt", "curves.csv", "dynamic.csv",
                                            "engineering.csv", "engineering_dynamic.csv", "errors.csv", "prony.csv",
                                            "quality.csv"));
}

TEST_F(InterruptedRun, LeavesEarlierResultsAsTheyWere) {
  static_cast<void>(run_study(study, results));
  const auto record = read_text(results / "study.json");
  fs::path beside;
  const auto fail = [&](const RunEvent& event) {
    if (const auto* kept = std::get_if<ResultsKeptBeside>(&event)) beside = kept->directory;
    if (std::holds_alternative<TestFinished>(event)) throw NumericalError("unstable");
  };
  EXPECT_THROW(static_cast<void>(run_study(study, results, {}, {.event = fail})), NumericalError);
  EXPECT_EQ(beside, results / "unfinished");
  EXPECT_EQ(read_text(results / "study.json"), record);
  EXPECT_TRUE(read_study_record(beside).has_tests);
  EXPECT_TRUE(ResultTransaction(study, results, {}).take_over().seconds)
      << "the results are complete, so nothing is to replace them";
  EXPECT_FALSE(fs::exists(beside));
}

TEST_F(InterruptedRun, GoesOnFromAPacking) {
  const auto packed = pack_study(study, results);
  EXPECT_THAT(packed.stages.at(0).tests, IsEmpty());
  EXPECT_THAT(files(), UnorderedElementsAre("study.json"));
  EXPECT_THAT(files("coarse"), UnorderedElementsAre("labels.npy", "labels.vti", "microstructure.csv",
                                                    "microstructure.svg", "packing.checkpoint.h5"));
  const auto run = run_study(study, results, {.resume = true});
  EXPECT_EQ(run.stages.at(0).microstructure.content<Microstructure<2>>()->particles,
            packed.stages.at(0).microstructure.content<Microstructure<2>>()->particles);
  EXPECT_TRUE(read_study_record(results).is_complete_run_of(study));
}

TEST_F(InterruptedRun, KeepsItsTestsWhenItIsPackedAgain) {
  run_until_tested("coarse");
  const auto curves = read_text(results / "curves.csv");
  static_cast<void>(pack_study(study, results));
  EXPECT_EQ(read_text(results / "curves.csv"), curves);
  EXPECT_TRUE(read_study_record(results).has_tests);
}

}  // namespace
}  // namespace breccia
