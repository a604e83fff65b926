// Tests of files that are in a directory before a sweep writes to it.

#include <csignal>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "good_deck.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "study_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using test::StudyDirectory;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Words = std::vector<std::string>;

TEST(EarlierSweeps, OfOtherTasksAreNotReplacedUnasked) {
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12"));
  const std::vector<std::string> seeds = {"--sweep", "stages.A.packing.seed=[1, 2]"};
  ASSERT_EQ(study.breccia("run", seeds).exit_code, 0);
  const auto table = read_text(study.result("sweep.csv"));
  const auto single = study.breccia("run");
  EXPECT_EQ(single.exit_code, 2);
  EXPECT_THAT(single.errors, StartsWith("out: here are the results of a sweep; "));
  auto others = seeds;
  others.insert(others.end(), {"--set", "stages.A.cells=10"});
  const auto refused = study.breccia("run", others);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors,
              AllOf(HasSubstr("out: here are the results of another sweep"),
                    HasSubstr("out/seed-1: here are complete results of another study"), HasSubstr("out/seed-2: ")));
  EXPECT_EQ(read_text(study.result("sweep.csv")), table);
  others.emplace_back("--overwrite");
  const auto replaced = study.breccia("run", others);
  EXPECT_EQ(replaced.exit_code, 0) << replaced.errors;
  EXPECT_NE(read_text(study.result("sweep.csv")), table);
  EXPECT_EQ(study.breccia("run", seeds).exit_code, 2);
}

// The record of a packing does not show who wrote the tables of a sweep.
TEST(EarlierSweeps, DoNotReplaceTablesOfOthersBesideAPacking) {
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12"));
  for (const std::string name : {"sweep.csv", "spread.csv", "sweep.svg"}) {
    ASSERT_EQ(study.breccia("pack").exit_code, 0);
    study.write("out/" + name, "mine");
    const auto run = study.breccia("run", {"--seeds", "2"});
    EXPECT_EQ(run.exit_code, 2) << run.output;
    EXPECT_THAT(run.errors, StartsWith("out/" + name + ": the results would replace this file, which Breccia did not"));
    EXPECT_EQ(read_text(study.result(name)), "mine");
    fs::remove_all(study.result(""));
  }
  ASSERT_EQ(study.breccia("pack").exit_code, 0);
  EXPECT_EQ(study.breccia("run", {"--seeds", "2"}).exit_code, 0);
}

/// A sweep over two seeds with complete results in `out`, and another one that is to replace them.
class ReplacedSweep : public testing::Test {
 protected:
  ReplacedSweep() { EXPECT_EQ(study_.breccia("run", seeds_).exit_code, 0); }

  [[nodiscard]] Words other(const Words& more) const {
    auto words = seeds_;
    words.insert(words.end(), {"--set", "stages.A.cells=40"});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void cut_off_in_the_first_task() const {
    const auto outcome = study_.breccia("run", other({"--overwrite", "--time-limit", "1 us"}));
    EXPECT_EQ(outcome.exit_code, 130) << outcome.errors;
    EXPECT_FALSE(fs::exists(study_.result("seed-2/unfinished")));
  }
  /// The results of a third study for the directory of the second task.
  [[nodiscard]] Words third(const Words& more) const {
    Words words = {"run",   "deck.toml",         "--threads", "1",
                   "--set", "stages.A.cells=16", "--set",     "stages.A.packing.seed=2"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void expect_the_results_of_the_other() const {
    const StudyDirectory whole(read_text(study_.path() / "deck.toml"));
    ASSERT_EQ(whole.breccia("run", other({})).exit_code, 0);
    EXPECT_EQ(read_text(study_.result("sweep.csv")), read_text(whole.result("sweep.csv")));
    EXPECT_EQ(study_.results(), whole.results());
    EXPECT_THAT(read_text(study_.result("sweep.json")), Not(HasSubstr("may_replace")));
  }

  const Words seeds_ = {"--sweep", "stages.A.packing.seed=[1, 2]"};
  const StudyDirectory study_{test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12")};
};

TEST_F(ReplacedSweep, ResumesFromAnInterruptionInItsFirstTask) {
  const auto table = read_text(study_.result("sweep.csv"));
  cut_off_in_the_first_task();
  EXPECT_EQ(read_text(study_.result("sweep.csv")), table);
  const auto resumed = study_.breccia("run", other({"--resume"}));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.errors;
  expect_the_results_of_the_other();
}

TEST_F(ReplacedSweep, ResumesFromAnInterruptionInItsSecondTask) {
  test::RunningCommand sweep(study_.path(), StudyDirectory::arguments("run", other({"--overwrite"})));
  ASSERT_TRUE(sweep.reaches([&] { return fs::exists(study_.result("seed-2/unfinished")); }));
  sweep.send(SIGINT);
  const auto outcome = sweep.wait();
  ASSERT_EQ(outcome.exit_code, 130) << outcome.errors;
  const auto resumed = study_.breccia("run", other({"--resume"}));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_THAT(resumed.output, HasSubstr("seed-1, complete already"));
  expect_the_results_of_the_other();
}

TEST_F(ReplacedSweep, DoesNotReplaceResultsWrittenAfterItsStart) {
  cut_off_in_the_first_task();
  const auto run = test::run_breccia(study_.path(), third({"--out", "out/seed-2", "--overwrite"}));
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto curves = read_text(study_.result("seed-2/curves.csv"));
  const auto resumed = study_.breccia("run", other({"--resume"}));
  EXPECT_EQ(resumed.exit_code, 2);
  EXPECT_THAT(resumed.errors, StartsWith("out/seed-2: cannot resume from these results: the overrides were"));
  EXPECT_EQ(read_text(study_.result("seed-2/curves.csv")), curves);
}

TEST_F(ReplacedSweep, DoesNotReplaceUnfinishedTestsWrittenAfterItsStart) {
  cut_off_in_the_first_task();
  ASSERT_EQ(test::run_breccia(study_.path(), third({"--out", "third"})).exit_code, 0);
  fs::rename(study_.path() / "third", study_.result("seed-2/unfinished"));
  const auto resumed = study_.breccia("run", other({"--resume"}));
  EXPECT_EQ(resumed.exit_code, 2);
  EXPECT_THAT(resumed.errors, StartsWith("out/seed-2/unfinished: here are complete results of another study"));
  EXPECT_TRUE(fs::exists(study_.result("seed-2/unfinished/curves.csv")));
}

TEST_F(ReplacedSweep, DoesNotReplaceOtherResultsInPlaceOfAFinishedTask) {
  const auto run = test::run_breccia(study_.path(), third({"--out", "out/seed-2", "--overwrite"}));
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto curves = read_text(study_.result("seed-2/curves.csv"));
  auto resume = seeds_;
  resume.emplace_back("--resume");
  const auto resumed = study_.breccia("run", resume);
  EXPECT_EQ(resumed.exit_code, 2);
  EXPECT_THAT(resumed.errors, StartsWith("out/seed-2: cannot resume from these results"));
  EXPECT_EQ(read_text(study_.result("seed-2/curves.csv")), curves);
}

TEST(EarlierSweeps, KeepTheirTablesWhileTheyAreMadeOnceMore) {
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12"));
  const std::vector<std::string> seeds = {"--sweep", "stages.A.packing.seed=[1, 2]"};
  ASSERT_EQ(study.breccia("run", seeds).exit_code, 0);
  const auto table = read_text(study.result("sweep.csv"));
  auto cut_off = seeds;
  cut_off.insert(cut_off.end(), {"--time-limit", "1 us"});
  EXPECT_EQ(study.breccia("run", cut_off).exit_code, 130);
  EXPECT_EQ(read_text(study.result("sweep.csv")), table);
}

}  // namespace
}  // namespace breccia
