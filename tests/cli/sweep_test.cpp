#include <csignal>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "good_deck.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "model_deck.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

using test::StudyDirectory;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

/// Three packings of few particles, quasi-static.
const std::string deck = test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12") +
                         "[sweep]\n\"stages.*.packing.seed\" = [1, 2, 3]\n";

std::vector<std::string> states(const StudyDirectory& study) {
  std::vector<std::string> all;
  const auto json = Json::parse(read_text(study.result("sweep.json")));
  for (const auto& task : json["tasks"]) all.push_back(task["state"]);
  return all;
}

CsvTable sweep_table(const StudyDirectory& study) {
  return read_csv(study.result("sweep.csv"),
                  {"task", "stages.*.packing.seed", "stage", "load", "boundary", "method", "cells", "error"});
}

TEST(Sweep, RunsEveryTaskLikeADeckWithOverrides) {
  const StudyDirectory study(deck);
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("task 2 of 3: seed-2"), HasSubstr("mean and standard deviation")));
  EXPECT_THAT(study.results(), AllOf(Contains("seed-1/curves.csv"), Contains("seed-3/A/modulus.svg"),
                                     Contains("sweep.svg"), Contains("spread.csv"), Contains("report.html")));
  EXPECT_THAT(states(study), ElementsAre("done", "done", "done"));
  EXPECT_THAT(read_text(study.result("sweep.svg")), HasSubstr("</svg>"));
  const StudyDirectory single(deck.substr(0, deck.find("[sweep]")));
  ASSERT_EQ(single.breccia("run", {"--set", "stages.A.packing.seed=2"}).exit_code, 0);
  EXPECT_EQ(read_text(study.result("seed-2/curves.csv")), read_text(single.result("curves.csv")));
}

TEST(Sweep, SeedsAreShortForASweepOverThem) {
  const StudyDirectory study(deck.substr(0, deck.find("[sweep]")));
  const auto run = study.breccia("run", {"--seeds", "2"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("task 2 of 2: seed-2"),
                                HasSubstr("A: modulus, mean and standard deviation over the seeds"), HasSubstr(" +- "),
                                HasSubstr("that of the mean of 2 boxes is 1.4 times smaller")));
  EXPECT_THAT(study.results(), AllOf(Contains("spread.csv"), Contains("seed-1/quality.csv")));
  EXPECT_THAT(study.breccia("check", {"--seeds", "3"}).output, testing::StartsWith("a sweep of 3 tasks\n"));
  for (const auto* number : {"1", "0", "-3", "1001", "many", "2.5"}) {
    const auto refused = study.breccia("run", {"--seeds", number});
    EXPECT_EQ(refused.exit_code, 2) << number;
    EXPECT_THAT(refused.errors, HasSubstr("--seeds")) << number;
  }
}

TEST(Sweep, ThatWillNotFitIsRefusedBeforeAnyTaskRuns) {
  // The tasks need 5 and 20 TB.
  const StudyDirectory study(test::good_deck);
  const auto run = study.breccia("run", {"--sweep", "stages.A.cells=[12, 90000, 180000]", "--sweep",
                                         "stages.A.packing.seed=[1, 2, 3]", "--set", "tests.method=quasistatic"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, AllOf(HasSubstr("cells-90000_seed-1 and 2 more: A: 90000 x 90000 cells take about "),
                                HasSubstr("cells-180000_seed-1 and 2 more: A: 180000 x 180000 cells take about "),
                                HasSubstr("would fit")));
  EXPECT_THAT(study.results(), testing::IsEmpty());
}

TEST(Sweep, PacksTheOtherTasksWhereOneCannotBePacked) {
  const StudyDirectory study(deck.substr(0, deck.find("[sweep]")));
  const auto pack = study.breccia("pack", {"--sweep", "stages.A.filler.fraction=[0.3, 0.85, 0.35]", "--quiet"});
  EXPECT_EQ(pack.exit_code, 3);
  EXPECT_THAT(pack.errors, AllOf(HasSubstr("\nfraction-0.85: A: "), Not(HasSubstr("fraction-0.3"))));
  EXPECT_TRUE(std::filesystem::exists(study.result("fraction-0.3/A/microstructure.csv")));
  EXPECT_FALSE(std::filesystem::exists(study.result("fraction-0.85")));
  EXPECT_TRUE(std::filesystem::exists(study.result("fraction-0.35/A/microstructure.csv")));
}

TEST(Sweep, CanBeNarrowedOnTheCommandLine) {
  const StudyDirectory study(deck);
  const auto run = study.breccia("run", {"--set", R"(sweep."stages.*.packing.seed"=[2])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("task 1 of 1: seed-2"));
  EXPECT_THAT(study.results(), Not(Contains("spread.csv"))) << "of one seed";
}

TEST(Sweep, TheTableHoldsTheCurvesOfAllTasks) {
  const StudyDirectory study(deck);
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  const auto table = sweep_table(study);
  std::size_t row = 0;
  for (const auto* seed : {"1", "2", "3"}) {
    const auto task = std::string("seed-") + seed;
    const auto curves = read_csv(study.result(task + "/curves.csv"), {"stage", "load", "boundary", "method", "cells"});
    for (std::size_t i = 0; i < curves.rows(); ++i, ++row) {
      ASSERT_EQ(table.text("task").at(row), task);
      ASSERT_EQ(table.text("stages.*.packing.seed").at(row), seed);
      ASSERT_EQ(table.text("boundary").at(row), curves.text("boundary")[i]);
      ASSERT_EQ(table.numbers("time_s").at(row), curves.numbers("time_s")[i]);
      ASSERT_EQ(table.numbers("modulus_Pa").at(row), curves.numbers("modulus_Pa")[i]);
    }
  }
  EXPECT_EQ(row, table.rows());
  const auto spread = read_csv(study.result("spread.csv"), {"stage", "load", "boundary", "method", "cells"});
  EXPECT_EQ(3 * spread.rows(), table.rows());
  EXPECT_THAT(spread.numbers("tasks"), testing::Each(3.0));
}

TEST(Sweep, ResumingRunsUnfinishedTasks) {
  const StudyDirectory study(deck);
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  const auto table = read_text(study.result("sweep.csv"));
  // Two tasks are incomplete, one is done.
  for (const auto* task : {"seed-1/study.json", "seed-2/study.json"}) {
    write_text(study.result(task),
               test::replaced(read_text(study.result(task)), "\"complete\": true", "\"complete\": false"));
  }
  const auto resumed = study.breccia("run", {"--resume"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_THAT(resumed.output,
              AllOf(HasSubstr("task 3 of 3: seed-3, complete already"), HasSubstr("seed-1\n"), HasSubstr("seed-2\n")));
  EXPECT_EQ(read_text(study.result("sweep.csv")), table);
  EXPECT_THAT(states(study), ElementsAre("done", "done", "done"));

  const auto other = study.breccia("run", {"--resume", "--set", "stages.A.cells=10"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.errors, AllOf(HasSubstr("out/seed-1: cannot resume from these results"), HasSubstr("out/seed-3")));
  const auto instead = study.breccia("run", {"--overwrite", "--set", "stages.A.cells=10"});
  EXPECT_EQ(instead.exit_code, 0) << instead.errors;
  EXPECT_THAT(instead.output, Not(HasSubstr("complete already")));

  write_text(study.result("seed-2/study.json"), "not even JSON");
  const auto foreign = study.breccia("run", {"--resume", "--set", "stages.A.cells=10"});
  EXPECT_THAT(foreign.errors, HasSubstr("out/seed-2/study.json: damaged, or not written by Breccia"));
}

TEST(Sweep, ResumingAGrownSweepRunsTheNewTasks) {
  const StudyDirectory study(deck);
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  study.write("deck.toml", test::replaced(deck, "[1, 2, 3]", "{ from = 1, to = 4 }  # one more"));
  const auto resumed = study.breccia("run", {"--resume"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_THAT(resumed.output,
              AllOf(HasSubstr("task 3 of 4: seed-3, complete already"), HasSubstr("task 4 of 4: seed-4\n")));
}

TEST(Sweep, ItsClosingTableNamesKeysAndValuesOnce) {
  const StudyDirectory study(deck.substr(0, deck.find("[sweep]")));
  const auto run =
      study.breccia("run", {"--sweep", "stages.A.filler.fraction=[0.1, 0.12]", "--set",
                            R"(tests.boundaries=["displacement", "traction"])", "--set", "tests.method=quasistatic"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("\nModulus of the last stage\n\n"
                                    "    fraction           0.1                        0.12\n"
                                    "        time  displacement      traction  displacement      traction\n"));
  // The values are those in the tables of a separate run.
  const StudyDirectory single(deck.substr(0, deck.find("[sweep]")));
  const auto alone =
      single.breccia("run", {"--set", "stages.A.filler.fraction=0.1", "--set",
                             R"(tests.boundaries=["displacement", "traction"])", "--set", "tests.method=quasistatic"});
  const auto row = alone.output.substr(alone.output.find("        1 ms  "), 40);
  EXPECT_THAT(run.output, HasSubstr("\n" + row));
}

TEST(Sweep, ResumingASingleStudy) {
  const StudyDirectory study(test::homogeneous_deck);
  const std::vector<std::string> options{"--resume", "--set", "tests.method=quasistatic", "--set", "stages.A.cells=4"};
  EXPECT_THAT(study.breccia("run", options).output, HasSubstr("Results are in out"));
  const auto again = study.breccia("run", options);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(again.output, "The results in out are complete\n");
}

TEST(Sweep, AFailedTaskDoesNotLoseTheOthers) {
  const StudyDirectory study(test::replaced(deck, "gap = \"0.1 mm\"", "gap = \"0 m\""));
  const auto failed = study.breccia(
      "run", {"--set", R"(sweep."stages.*.packing.seed"=[1])", "--sweep", "stages.A.filler.fraction=[0.85, 0.3]"});
  EXPECT_EQ(failed.exit_code, 3);
  EXPECT_THAT(failed.errors, AllOf(testing::StartsWith("seed-1_fraction-0.85: A: "), HasSubstr("between them jam: ")));
  EXPECT_THAT(states(study), ElementsAre("failed", "done"));
  EXPECT_THAT(read_text(study.result("sweep.csv")), HasSubstr("seed-1_fraction-0.3,1,0.3,A,shear"));
}

TEST(Sweep, AnInterruptionKeepsFinishedTasks) {
  // The second task would go on for days.
  const auto slow = test::replaced(std::string(test::homogeneous_deck),
                                   R"({ terms = [{ time = "10 ms", modulus = "0.5 MPa" }] })", R"("0.5 MPa")");
  const StudyDirectory study(slow +
                             "[tests.dynamic]\nmass_scaling_factors = [0.1, 1]\n"
                             "[sweep]\n\"tests.times.1\" = [\"2 ms\", \"5000 s\"]\n");
  test::RunningCommand run(study.path(), StudyDirectory::arguments("run"));
  ASSERT_TRUE(run.reaches([&] { return std::filesystem::exists(study.result("times-1-5000-s/A/microstructure.csv")); }))
      << run.wait().errors;
  run.send(SIGINT);
  EXPECT_EQ(run.wait().exit_code, 130);
  EXPECT_THAT(states(study), ElementsAre("done", "waiting"));
  EXPECT_THAT(study.results(), Contains("sweep.csv"));
}

TEST(Sweep, QuantitiesAreNumbersInOneUnit) {
  const StudyDirectory study(deck.substr(0, deck.find("[sweep]")));
  const auto run = study.breccia(
      "run", {"--sweep", R"(stages.A.filler.gap=["0.1 mm", "150 um"])", "--sweep", R"(tests.volumetric=["averaged"])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto json = Json::parse(read_text(study.result("sweep.json")));
  EXPECT_EQ(json["quantities"], Json::parse(R"({ "stages.A.filler.gap": { "unit": "mm", "numbers": [0.1, 0.15] } })"));
}

TEST(Sweep, CheckShowsTheTasks) {
  const StudyDirectory study(deck);
  const auto check = study.breccia("check");
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, AllOf(testing::StartsWith("a sweep of 3 tasks\n"), HasSubstr("  seed-3  3\n"),
                                  HasSubstr("12 x 12 cells")));
}

TEST(Sweep, CheckPlansEveryTask) {
  const StudyDirectory study(deck.substr(0, deck.find("[sweep]")));
  const std::vector<std::string> cells = {"--sweep", "stages.A.cells=[12, 24, 36]", "--seeds", "2"};
  const auto check = study.breccia("check", cells);
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, AllOf(HasSubstr("  cells-24_seed-1 and 1 more: about "), HasSubstr("\nall 6 tasks about "),
                                  HasSubstr(" of memory, in cells-36_seed-1 and 1 more\n")));
}

TEST(Sweep, CheckRefusesWhatRunRefuses) {
  const StudyDirectory study(test::good_deck);
  const auto check = study.breccia(
      "check", {"--sweep", "stages.A.cells=[12, 90000, 180000]", "--sweep", "stages.A.packing.seed=[1, 2, 3]"});
  EXPECT_EQ(check.exit_code, 2) << check.output;
  EXPECT_THAT(check.errors, AllOf(HasSubstr("cells-90000_seed-1 and 2 more: A: 90000 x 90000 cells take about "),
                                  HasSubstr("cells-180000_seed-1 and 2 more: A: 180000 x 180000 cells take about ")));
}

TEST(Sweep, CheckSaysWhichTasksCannotBePacked) {
  const StudyDirectory study(deck.substr(0, deck.find("[sweep]")));
  const auto check = study.breccia("check", {"--sweep", "stages.A.filler.fraction=[0.3, 0.85, 0.35]"});
  EXPECT_EQ(check.exit_code, 3);
  EXPECT_THAT(check.output, AllOf(HasSubstr("  fraction-0.35: about "), HasSubstr("all 3 tasks about ")));
  EXPECT_THAT(check.errors, AllOf(testing::StartsWith("fraction-0.85: A: "), Not(HasSubstr("fraction-0.3"))));
}

TEST(Sweep, PackPacksEveryTask) {
  const StudyDirectory study(deck);
  const auto pack = study.breccia("pack");
  EXPECT_EQ(pack.exit_code, 0) << pack.errors;
  EXPECT_THAT(study.results(), AllOf(Contains("seed-1/A/microstructure.csv"), Contains("seed-3/study.json")));
  EXPECT_NE(read_text(study.result("seed-1/A/microstructure.csv")),
            read_text(study.result("seed-2/A/microstructure.csv")));
  EXPECT_THAT(study.breccia("run", {"--resume"}).output, Not(HasSubstr("complete already"))) << "packed alone";
}

TEST(Sweep, MistakesInAnyTaskPreventTheSweep) {
  const StudyDirectory study(deck);
  const auto run = study.breccia("run", {"--sweep", R"(tests.volumetric=["averaged", "norm"])"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, HasSubstr("tests.volumetric: expected one of \"averaged\", \"standard\", got \"norm\""));
  EXPECT_THAT(study.results(), testing::IsEmpty());
}

}  // namespace
}  // namespace breccia
