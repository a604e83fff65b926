// What is in a directory before a command writes to it.

#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/io/text_file.hpp"

#include "good_deck.hpp"
#include "messages.hpp"
#include "study_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using test::StudyDirectory;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// One box of few particles, quasi-static, with complete results in `out`.
class EarlierResults : public testing::Test {
 protected:
  EarlierResults() {
    const auto run = study_.breccia("run");
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    before_ = contents();
  }

  /// All files in `out` with their bytes.
  [[nodiscard]] std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const auto& name : study_.results()) all[name] = read_text(study_.result(name));
    return all;
  }
  void expect_nothing_lost() const { EXPECT_EQ(contents(), before_); }

  StudyDirectory study_{test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12")};
  std::map<std::string, std::string> before_;
  const std::vector<std::string> other_ = {"--set", "stages.A.cells=10"};
  const std::vector<std::string> other_instead_ = {"--set", "stages.A.cells=10", "--overwrite"};
  const std::vector<std::string> jams_ = {"--set", "stages.A.filler.fraction=0.8", "--overwrite"};
};

TEST_F(EarlierResults, OfAnotherStudyAreNotReplacedUnasked) {
  for (const auto* command : {"run", "pack"}) {
    const auto outcome = study_.breccia(command, other_);
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_THAT(outcome.errors, AllOf(StartsWith("out: here are complete results of another study: the overrides were "
                                                 R"([], are ["stages.A.cells=10"])"),
                                      HasSubstr("--overwrite"), HasSubstr("--out")))
        << command;
    expect_nothing_lost();
  }
}

TEST_F(EarlierResults, StayWhereARunFails) {
  const auto run = study_.breccia("run", jams_);
  EXPECT_EQ(run.exit_code, 3) << run.errors;
  expect_nothing_lost();
}

TEST_F(EarlierResults, StayUntilTheNewOnesAreWhole) {
  study_.write("out/notes.txt", "mine");
  study_.write("out/A/notes.txt", "mine");
  before_ = contents();
  auto cut_off = other_instead_;
  cut_off.insert(cut_off.end(), {"--time-limit", "1 us"});
  const auto run = study_.breccia("run", cut_off);
  EXPECT_EQ(run.exit_code, 130) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("The earlier results stay until the new ones, in out/unfinished, are whole"));
  for (const auto& [name, bytes] : before_) EXPECT_EQ(read_text(study_.result(name)), bytes) << name;

  auto and_resume = other_;
  and_resume.emplace_back("--resume");
  const auto resumed = study_.breccia("run", and_resume);
  EXPECT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_FALSE(fs::exists(study_.result("unfinished")));
  EXPECT_EQ(read_text(study_.result("notes.txt")), "mine");
  EXPECT_EQ(read_text(study_.result("A/notes.txt")), "mine");
  const StudyDirectory alone(read_text(study_.path() / "deck.toml"));
  ASSERT_EQ(alone.breccia("run", other_).exit_code, 0);
  EXPECT_EQ(read_text(study_.result("curves.csv")), read_text(alone.result("curves.csv")));
}

TEST_F(EarlierResults, OfStagesThatAreNoMoreAreReplacedToo) {
  auto deck = read_text(study_.path() / "deck.toml");
  study_.write("deck.toml", test::replaced(deck, R"("A")", R"("B")"));
  const auto run = study_.breccia("run", {"--overwrite"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(study_.results(), AllOf(Contains("B/microstructure.csv"), Not(Contains(StartsWith("A/"))),
                                      Not(Contains(StartsWith("unfinished")))));
}

TEST_F(EarlierResults, OfTheSameStudyAreMadeOnceMore) {
  const auto run = study_.breccia("run");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(read_text(study_.result("curves.csv")), before_["curves.csv"]);
  EXPECT_EQ(study_.results().size(), before_.size());
  EXPECT_THAT(study_.breccia("pack").output, HasSubstr("The results in out are complete"));
}

TEST_F(EarlierResults, AreNotReplacedByTwoProcessesAtOnce) {
  test::RunningCommand first(study_.path(), {"run", "deck.toml", "--out", "out", "--overwrite", "--threads", "1",
                                             "--set", "stages.A.cells=160"});
  ASSERT_TRUE(first.reaches([&] { return fs::exists(study_.result("unfinished/study.json")); }));
  const StudyDirectory elsewhere(read_text(study_.path() / "deck.toml"));
  const auto second = test::run_breccia(elsewhere.path(), {"run", "deck.toml", "--overwrite", "--set",
                                                           "stages.A.cells=8", "--out", study_.result("").string()});
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_THAT(second.errors, HasSubstr("another process of Breccia writes its results here"));
  EXPECT_EQ(first.wait().exit_code, 0);
}

TEST_F(EarlierResults, OfASingleStudyAreNotMixedWithThoseOfASweep) {
  const std::vector<std::string> seeds = {"--sweep", "stages.A.packing.seed=[1, 2]"};
  const auto sweep = study_.breccia("run", seeds);
  EXPECT_EQ(sweep.exit_code, 2);
  EXPECT_EQ(sweep.errors, "out: here are the results of a single study; take another directory (--out out-sweep)\n");
  expect_nothing_lost();
}

TEST_F(EarlierResults, OfARunAreNotReplacedByThoseOfOtherCommands) {
  study_.write("aged.toml", "density = \"1.48 g/cm^3\"\nbulk = \"3.6 GPa\"\nshear = \"0.5 MPa\"\n");
  const auto respond = test::run_breccia(study_.path(), {"respond", "out", "--material", "aged.toml", "--out", "out"});
  EXPECT_EQ(respond.exit_code, 2);
  EXPECT_THAT(respond.errors, HasSubstr("out: here are the results of a study"));
  study_.write("G.csv", "time_s,modulus_Pa\n1,3\n2,2\n3,1.5\n4,1.2\n");
  const auto fit = test::run_breccia(study_.path(), {"fit", "G.csv", "--out", "out"});
  EXPECT_EQ(fit.exit_code, 2);
  EXPECT_THAT(fit.errors, HasSubstr("out: here are the results of a study"));
  expect_nothing_lost();
}

TEST(ForeignFiles, AreNotReplaced) {
  const StudyDirectory study(test::good_deck);
  fs::create_directories(study.result("A"));
  study.write("out/curves.csv", "mine");
  study.write("out/A/microstructure.csv", "mine");
  for (const auto* command : {"run", "pack"}) {
    const auto outcome = study.breccia(command);
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_THAT(outcome.errors,
                AllOf(HasSubstr("out/curves.csv: the results would replace this file, which Breccia did "
                                "not write"),
                      HasSubstr("\nout/A/microstructure.csv: ")));
  }
  EXPECT_EQ(read_text(study.result("curves.csv")), "mine");
}

TEST(ForeignFiles, MayBeARecordOfSomethingElse) {
  const StudyDirectory study(test::good_deck);
  fs::create_directories(study.result(""));
  study.write("out/study.json", "{\"patients\": 12}");
  const std::vector<std::vector<std::string>> options = {{}, {"--resume"}, {"--overwrite"}};
  for (const auto& option : options) {
    const auto outcome = study.breccia("run", option);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("out/study.json: the results would replace this file"));
    EXPECT_EQ(read_text(study.result("study.json")), "{\"patients\": 12}");
  }
}

TEST(ForeignFiles, InUnfinishedAreNotTouched) {
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12"));
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  fs::create_directories(study.result("unfinished"));
  study.write("out/unfinished/thesis.txt", "mine");
  const auto run = study.breccia("run");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, HasSubstr("out/unfinished/thesis.txt: in the way of unfinished results"));
  EXPECT_EQ(read_text(study.result("unfinished/thesis.txt")), "mine");
}

TEST(SeveralCurves, AreNotFittedAsOne) {
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12"));
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  const auto fit = test::run_breccia(study.path(), {"fit", "out/curves.csv"});
  EXPECT_EQ(fit.exit_code, 2);
  EXPECT_THAT(fit.errors, HasSubstr("out/curves.csv: results with several curves"));
}

TEST(ForeignFiles, AreNotReplacedByFits) {
  const StudyDirectory study(test::good_deck);
  study.write("G.csv", "time_s,modulus_Pa\n1,3\n2,2\n3,1.5\n4,1.2\n");
  study.write("H.csv", "time_s,modulus_Pa\n1,30\n2,20\n3,15\n4,12\n");
  fs::create_directory(study.path() / "out");
  study.write("out/prony.csv", "mine");
  const auto fit = [&](const std::string& file, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"fit", file, "--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run_breccia(study.path(), arguments);
  };
  const auto foreign = fit("G.csv");
  EXPECT_EQ(foreign.exit_code, 2);
  EXPECT_THAT(foreign.errors, HasSubstr("out: the results would replace prony.csv, which `breccia fit` did not write"));
  EXPECT_EQ(read_text(study.result("prony.csv")), "mine");
  fs::remove(study.result("prony.csv"));

  ASSERT_EQ(fit("G.csv").exit_code, 0);
  const auto first = read_text(study.result("prony.csv"));
  EXPECT_EQ(fit("G.csv").exit_code, 0) << "of the same file";
  const auto other = fit("H.csv");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.errors, HasSubstr(R"(out: here is what `breccia fit` made of "G.csv"; replace it (--overwrite))"));
  EXPECT_EQ(read_text(study.result("prony.csv")), first);
  EXPECT_EQ(fit("H.csv", {"--overwrite"}).exit_code, 0);
  EXPECT_NE(read_text(study.result("prony.csv")), first);
}

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

TEST(EarlierSweeps, ThatAreBeingReplacedCanBeResumed) {
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12"));
  const std::vector<std::string> seeds = {"--sweep", "stages.A.packing.seed=[1, 2]"};
  ASSERT_EQ(study.breccia("run", seeds).exit_code, 0);
  // The first task of the other sweep is done, the second not begun.
  auto others = seeds;
  others.insert(others.end(), {"--set", "stages.A.cells=10"});
  const StudyDirectory whole(read_text(study.path() / "deck.toml"));
  ASSERT_EQ(whole.breccia("run", others).exit_code, 0);
  for (const auto* name : {"seed-1", "sweep.json"}) {
    fs::remove_all(study.result(name));
    fs::copy(whole.result(name), study.result(name), fs::copy_options::recursive);
  }
  others.emplace_back("--resume");
  const auto resumed = study.breccia("run", others);
  EXPECT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_THAT(resumed.output, HasSubstr("seed-1, complete already"));
  EXPECT_EQ(read_text(study.result("sweep.csv")), read_text(whole.result("sweep.csv")));
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

TEST(StageNames, OfFilesOfResultsAreRefused) {
  for (const auto* name : {"report.html", "sweep.csv", "sweep.json", "sweep.svg", "spread.csv", "unfinished",
                           "Study.json", "curves.csv"}) {
    const StudyDirectory study(test::replaced(std::string(test::good_deck), R"("A")", fmt::format("\"{}\"", name)));
    const auto check = study.breccia("check");
    EXPECT_EQ(check.exit_code, 2) << name;
    EXPECT_THAT(check.errors, HasSubstr("is the name of a file of results")) << name;
  }
}

TEST(StageNames, MayEndLikeAHalfWrittenFile) {
  const auto deck = test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12");
  const StudyDirectory study(test::replaced(deck, R"("A")", R"("a.partial")"));
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  const auto again = study.breccia("run");
  EXPECT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_EQ(study.breccia("run", {"--resume"}).exit_code, 0);
}

}  // namespace
}  // namespace breccia
