#include "campaign/sweep_directory.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "campaign/deck_study.hpp"
#include "campaign/earlier_results.hpp"
#include "campaign/sweep_temperatures.hpp"
#include "messages.hpp"
#include "results/sweep_tables.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using testing::Each;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A sweep whose tasks differ only in one key.
Sweep sweep_over(const std::string& path, const std::vector<std::string>& values) {
  Sweep sweep;
  sweep.keys = {{path, "key", false}};
  for (const auto& value : values) {
    auto& task = sweep.tasks.emplace_back();
    task.name = "key-" + value;
    task.labels = {task.name};
    task.values = {value};
    task.study = test::study_of_deck(task.name);
  }
  return sweep;
}

class SweepDirectoryTest : public testing::Test {
 protected:
  void leave(const std::string& task, const Study& study, const StudyResult& result) const {
    test::leave(results / task, study, result);
  }
  /// Writes `sweep.json` with the states of the tasks and the results that they may replace.
  void write_record(const Sweep& of, const std::vector<TaskState>& states,
                    const std::vector<std::vector<std::string>>& replaceable = {{}, {}}) const {
    fs::create_directories(results);
    SweepResult result;
    for (const auto state : states) result.push_back({.state = state});
    write_sweep_record(results, of, result, replaceable);
  }
  [[nodiscard]] std::string refusal(const RunOptions& options) const {
    return test::message_of<InputError>([&] { open(options); });
  }
  [[nodiscard]] std::vector<std::vector<std::string>> replaceable(const RunOptions& options) const {
    std::vector<std::vector<std::string>> hashes;
    for (const auto& of_task : options_of_tasks(options)) hashes.push_back(of_task.replaceable);
    return hashes;
  }
  [[nodiscard]] std::vector<RunOptions> options_of_tasks(const RunOptions& options) const {
    return SweepDirectory(sweep, results, options).options_of_tasks();
  }
  [[nodiscard]] std::vector<std::string> hashes_in(const fs::path& place) const {
    EarlierResults earlier(other, place);
    earlier.read();
    return earlier.hashes;
  }
  void open(const RunOptions& options) const { const SweepDirectory held(sweep, results, options); }

  Sweep sweep = sweep_over("stages.0.cells", {"8", "12"});
  const Study other = test::study_of_deck("other");
  test::TemporaryDirectory directory;
  const fs::path results = directory.path() / "results";
};

TEST_F(SweepDirectoryTest, IsFreeWhereNothingIs) {
  EXPECT_NO_THROW(open({}));
  EXPECT_THAT(replaceable({}), ElementsAre(IsEmpty(), IsEmpty()));
}

// Files that others have put there since are not replaced.
TEST_F(SweepDirectoryTest, IsOverwrittenAsItWasWhenTheSweepBegan) {
  leave("key-12", other, test::complete_result());
  const auto hashes = hashes_in(results / "key-12");
  EXPECT_THAT(hashes, SizeIs(1));
  EXPECT_THAT(replaceable({.overwrite = true}), ElementsAre(IsEmpty(), hashes));
  EXPECT_THAT(options_of_tasks({.overwrite = true}), Each(Field(&RunOptions::overwrite, false)));
  EXPECT_NO_THROW(open({.overwrite = true}));
}

TEST_F(SweepDirectoryTest, IsResumedAsItsRecordSays) {
  write_record(sweep, {TaskState::done, TaskState::waiting}, {{"aa"}, {"bb", "cc"}});
  EXPECT_THAT(replaceable({.resume = true}), ElementsAre(IsEmpty(), ElementsAre("bb", "cc")))
      << "what is done replaces nothing any more";
  EXPECT_THAT(replaceable({}), ElementsAre(IsEmpty(), IsEmpty()));
  write_text(results / "sweep.json", R"({"program": "breccia", "tasks": [7, {"name": "key-8"}]})");
  EXPECT_THAT(replaceable({.resume = true}), ElementsAre(IsEmpty(), IsEmpty()));
  write_text(results / "sweep.json", R"({"tasks": [{"name": "key-8", "may_replace": ["aa"]}]})");
  EXPECT_THAT(refusal({.resume = true}), HasSubstr("sweep.json: the results would replace this file"))
      << "not of Breccia";
}

TEST_F(SweepDirectoryTest, IsRefusedForAllTasksAtOnce) {
  leave("key-8", other, test::complete_result());
  leave("key-12", other, test::tested_result());
  const auto message = refusal({});
  EXPECT_THAT(message, HasSubstr("results/key-8: here are complete results of another study"));
  EXPECT_THAT(message, HasSubstr("\n" + (results / "key-12").string() + ": here are results of another study"));
}

TEST_F(SweepDirectoryTest, OfASingleStudyIsRefused) {
  test::leave(results, other, test::tested_result());
  EXPECT_THAT(refusal({.overwrite = true}),
              HasSubstr("results: here are the results of a single study; take another directory such as " +
                        results.string() + "-sweep"));
}

TEST_F(SweepDirectoryTest, OfAnotherSweepIsReplacedOnRequestAlone) {
  write_record(sweep_over("stages.0.cells", {"16", "24"}), {TaskState::done, TaskState::waiting});
  EXPECT_THAT(refusal({}),
              HasSubstr("results: here are the results of another sweep; replace them, add to them or take another "
                        "directory"));
  EXPECT_NO_THROW(open({.resume = true}));
  EXPECT_NO_THROW(open({.overwrite = true}));
  write_record(sweep_over("stages.0.cells", {"16", "24"}), {TaskState::waiting, TaskState::failed});
  EXPECT_NO_THROW(open({})) << "nothing of it is done";
  write_record(sweep, {TaskState::done, TaskState::done});
  EXPECT_NO_THROW(open({})) << "the same sweep";
}

TEST_F(SweepDirectoryTest, WithForeignTablesIsRefused) {
  fs::create_directories(results);
  write_text(results / "sweep.csv", "mine");
  EXPECT_THAT(refusal({.overwrite = true}),
              HasSubstr("results/sweep.csv: the results would replace this file, which Breccia did not write"));
}

TEST_F(SweepDirectoryTest, WithALinkForATaskIsRefused) {
  test::leave(directory.path() / "victim", other, test::complete_result());
  fs::create_directories(results);
  fs::create_directory_symlink("../victim", results / "key-8");
  EXPECT_THAT(refusal({.overwrite = true}), HasSubstr("results/key-8: a symbolic link, through which files elsewhere"));
}

TEST_F(SweepDirectoryTest, IsHeldByOneProcess) {
  {
    const SweepDirectory held(sweep, results, {});
    EXPECT_THROW(open({}), DirectoryInUse);
  }
  leave("key-8", sweep.tasks[0].study, test::tested_result());
  const DirectoryLock of_a_task(results / "key-8");
  EXPECT_THROW(open({}), DirectoryInUse);
}

TEST_F(SweepDirectoryTest, OfASingleTaskWithoutANameIsHeldByTheTask) {
  test::leave(results, other, test::tested_result());
  Sweep single;
  single.tasks.emplace_back().study = other;
  const SweepDirectory held(single, results, {});
  EXPECT_NO_THROW(ResultTransaction run(other, results, {}));
}

TEST_F(SweepDirectoryTest, KnowsTheTasksThatAreComplete) {
  leave("key-12", sweep.tasks[1].study, test::complete_result());
  const auto runs = SweepDirectory(sweep, results, {.resume = true}).complete_runs();
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].seconds, std::nullopt);
  EXPECT_EQ(runs[1].seconds, 2.5);
  EXPECT_THAT(runs[1].note, HasSubstr("key-12: missing since the run: checksums.txt"));
}

TEST(SweepTemperatures, AreAnsweredByTheFirstTaskThatDiffersInThemAlone) {
  auto sweep = sweep_over("materials.binder.temperature_shift.temperature", {"20 degC", "30 degC", "40 degC"});
  EXPECT_EQ(task_that_answers(sweep, 0), std::nullopt) << "the first is computed";
  EXPECT_EQ(task_that_answers(sweep, 1), 0U);
  EXPECT_EQ(task_that_answers(sweep, 2), 0U);
  sweep.keys.push_back({"stages.0.cells", "cells", false});
  for (std::size_t i = 0; i < 3; ++i) sweep.tasks[i].values.emplace_back(i == 0 ? "8" : "12");
  EXPECT_EQ(task_that_answers(sweep, 1), std::nullopt) << "on another grid";
  EXPECT_EQ(task_that_answers(sweep, 2), 1U);
}

TEST(SweepTemperatures, AreNotAnsweredOnOtherKeys) {
  for (const auto* path : {"materials.binder.temperature_shift.reference", "materials.binder.temperature",
                           "stages.binder.temperature_shift.temperature"}) {
    EXPECT_EQ(task_that_answers(sweep_over(path, {"20 degC", "30 degC"}), 1), std::nullopt) << path;
  }
}

TEST(SweepTemperatures, AreNotAnsweredWhereTheTestsLeaveMoreThanResponses) {
  auto sweep = sweep_over("materials.binder.temperature_shift.temperature", {"20 degC", "30 degC"});
  auto& tests = sweep.tasks[1].study.tests;
  const auto usual = tests;
  const auto answering = [&] { return task_that_answers(sweep, 1); };
  tests.field_times = {tests.last_time};
  EXPECT_EQ(answering(), 0U) << "the usual map is left out";
  tests.field_times = {0.5 * tests.last_time};
  EXPECT_EQ(answering(), std::nullopt) << "maps at a time of the deck's own take a run";
  tests.field_times = {tests.last_time};
  tests.lists_field_times = true;
  EXPECT_EQ(answering(), std::nullopt) << "also where the deck lists the last time alone";
  tests = usual;
  tests.methods = {Method::quasistatic, Method::dynamic};
  EXPECT_EQ(answering(), std::nullopt);
  tests = usual;
  tests.quasistatic.solver = Solver::stepping;
  EXPECT_EQ(answering(), std::nullopt);
  tests = usual;
  tests.quasistatic.range = SampledRange::times;
  EXPECT_EQ(answering(), std::nullopt);
}

}  // namespace
}  // namespace breccia
