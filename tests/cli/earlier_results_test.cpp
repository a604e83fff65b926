// Tests of files that are in a directory before a command writes to it.

#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
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
using testing::AnyOf;
using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Words = std::vector<std::string>;

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
                                      EndsWith(command == std::string("run")
                                                   ? "; replace them (--overwrite) or take another directory (--out)\n"
                                                   : "; take another directory (--out)\n")))
        << command;
    expect_nothing_lost();
  }
}

TEST_F(EarlierResults, AreKeptIfARunFails) {
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
  EXPECT_THAT(run.output,
              HasSubstr("The earlier results are kept until the new ones, in out/unfinished, are complete"));
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

TEST_F(EarlierResults, OfRemovedStagesAreReplacedToo) {
  auto deck = read_text(study_.path() / "deck.toml");
  study_.write("deck.toml", test::replaced(deck, R"("A")", R"("B")"));
  const auto run = study_.breccia("run", {"--overwrite"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(study_.results(), AllOf(Contains("B/microstructure.csv"), Not(Contains(StartsWith("A/"))),
                                      Not(Contains(StartsWith("unfinished")))));
}

TEST_F(EarlierResults, AreReplacedWithoutTheFilesOfTheirUser) {
  const Words mine = {"sweep.csv", "spread.csv", "sweep.svg", "A/fields-mine-stress.svg", "A/my-dynamic-data.h5"};
  for (const auto& name : mine) study_.write("out/" + name, "mine");
  study_.write("out/sweep.json", "{\"mine\": 1}");
  const auto run = study_.breccia("run", other_instead_);
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_NE(read_text(study_.result("study.json")), before_["study.json"]);
  for (const auto& name : mine) EXPECT_EQ(read_text(study_.result(name)), "mine") << name;
  EXPECT_EQ(read_text(study_.result("sweep.json")), "{\"mine\": 1}");
  const auto report = test::run_breccia(study_.path(), {"report", "out"});
  EXPECT_EQ(report.exit_code, 0) << report.errors;
}

TEST_F(EarlierResults, OfTheSameStudyAreMadeOnceMore) {
  const auto run = study_.breccia("run");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(read_text(study_.result("curves.csv")), before_["curves.csv"]);
  EXPECT_EQ(study_.results().size(), before_.size());
  EXPECT_THAT(study_.breccia("pack").output, HasSubstr("The results in out are complete"));
}

TEST_F(EarlierResults, WithoutTheirChecksumsAreTakenWithANote) {
  const auto note =
      "out: missing since the run: checksums.txt, against which the other files cannot be checked now; it is "
      "written anew for the files as they are\n";
  for (const Words& command : {Words{"run", "--resume"}, {"pack"}}) {
    fs::remove(study_.result("checksums.txt"));
    const auto outcome = study_.breccia(command.front(), {command.begin() + 1, command.end()});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.errors, note);
    EXPECT_THAT(outcome.output, HasSubstr("The results in out are complete"));
    expect_nothing_lost();
  }
  EXPECT_EQ(study_.breccia("run", {"--resume"}).errors, "");
}

// An older or a newer one.
TEST_F(EarlierResults, OfAnotherFormatAreRefusedWithTheCommandThatHelps) {
  study_.write("aged.toml", "density = '1.48 g/cm^3'\nbulk = '3.6 GPa'\nshear = '0.5 MPa'\n");
  for (const auto* version : {"0.0.1", "9.0.0"}) {
    auto record = test::replaced(before_["study.json"], R"("version": ")" BRECCIA_VERSION,
                                 std::string(R"("version": ")") + version);
    record = test::replaced(record, "\"stages\": [", "\"boxes\": [");
    study_.write("out/study.json", record);
    for (const Words& command : {Words{"export", "out", "--format", "abaqus"},
                                 {"respond", "out", "--material", "aged.toml"},
                                 {"report", "out"}}) {
      const auto outcome = test::run_breccia(study_.path(), command);
      EXPECT_EQ(outcome.exit_code, 4) << command.front();
      EXPECT_THAT(outcome.errors,
                  AllOf(StartsWith("out/study.json: not as `breccia run` writes it"),
                        HasSubstr(std::string("it is of version ") + version + " of Breccia, this is version "),
                        EndsWith("or run the study again and replace these results (breccia run DECK --out out "
                                 "--overwrite)\n")));
    }
    const auto run = study_.breccia("run");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.errors, AllOf(HasSubstr(std::string("they are of version ") + version),
                                  EndsWith("replace them (--overwrite) or take another directory (--out)\n")));
    const auto resumed = study_.breccia("run", {"--resume"});
    EXPECT_EQ(resumed.exit_code, 2);
    EXPECT_THAT(resumed.errors, HasSubstr("run with --overwrite instead of --resume"));
    EXPECT_EQ(study_.breccia("pack").exit_code, 2);
    EXPECT_EQ(read_text(study_.result("study.json")), record);
  }
  EXPECT_EQ(study_.breccia("run", {"--overwrite"}).exit_code, 0);
  EXPECT_EQ(read_text(study_.result("curves.csv")), before_["curves.csv"]);
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

TEST_F(EarlierResults, ThatAreUnfinishedMayHaveLostTheirRecord) {
  // These are the files of a run that was killed while it removed the files of another run in `unfinished`.
  fs::create_directories(study_.result("unfinished"));
  fs::copy(study_.result("A"), study_.result("unfinished/A"));
  fs::copy(study_.result("A"), study_.result("unfinished/old"));
  study_.write("out/unfinished/old/microstructure.csv.17.partial", "x_m");
  fs::copy(study_.result("curves.csv"), study_.result("unfinished/curves.csv"));
  const auto run = study_.breccia("run", other_instead_);
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(study_.results(), Not(Contains(AnyOf(StartsWith("unfinished"), StartsWith("old")))));
}

TEST_F(EarlierResults, OfASweepAreNotGoneOnFromByASingleStudy) {
  const StudyDirectory sweep(read_text(study_.path() / "deck.toml"));
  ASSERT_EQ(sweep.breccia("run", {"--sweep", "stages.A.packing.seed=[1, 2]"}).exit_code, 0);
  const auto single = sweep.breccia("run", {"--resume"});
  EXPECT_EQ(single.exit_code, 2);
  EXPECT_THAT(single.errors, StartsWith("out: here are the results of a sweep; "));
}

TEST_F(EarlierResults, OfASingleStudyAreNotMixedWithThoseOfASweep) {
  const std::vector<std::string> seeds = {"--sweep", "stages.A.packing.seed=[1, 2]"};
  const auto sweep = study_.breccia("run", seeds);
  EXPECT_EQ(sweep.exit_code, 2);
  EXPECT_EQ(sweep.errors, "out: here are the results of a single study; take another directory (--out out-sweep)\n");
  const auto with_slash = test::run_breccia(study_.path(), {"run", "deck.toml", "--out", "out/", "--seeds", "2"});
  EXPECT_THAT(with_slash.errors, HasSubstr("take another directory (--out out-sweep)\n"));
  const auto from_within = test::run_breccia(study_.result(""), {"run", "../deck.toml", "--out", ".", "--seeds", "2"});
  EXPECT_EQ(from_within.errors,
            ".: here are the results of a single study; take another directory (--out ../out-sweep)\n");
  for (const auto* printed : {"stdout", "stderr"}) std::filesystem::remove(study_.result(printed));
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

TEST(ForeignFiles, InTheDirectoryOfAStageThatIsNotPackedAreKept) {
  const StudyDirectory study(test::good_deck);
  fs::create_directories(study.result("A"));
  study.write("out/A/study.json", "{\"mine\": 1}");
  for (const auto* command : {"run", "pack"}) {
    EXPECT_EQ(study.breccia(command, {"--set", "stages.A.filler.fraction=0.9"}).exit_code, 3) << command;
    EXPECT_EQ(read_text(study.result("A/study.json")), "{\"mine\": 1}");
  }
}

TEST(ForeignFiles, MayEndLikeHalfWrittenFiles) {
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12"));
  fs::create_directories(study.result("A"));
  const Words mine = {"data.12.partial", "A/data.12.partial"};
  const Words left = {"curves.csv.12.partial", "A/response.h5.12.partial"};
  for (const auto& name : mine) study.write("out/" + name, "mine");
  for (const auto& name : left) study.write("out/" + name, "half");
  for (const Words& options : {Words{"--resume"}, {}, {"--overwrite", "--set", "stages.A.cells=10"}}) {
    ASSERT_EQ(study.breccia("run", options).exit_code, 0);
    for (const auto& name : mine) EXPECT_EQ(read_text(study.result(name)), "mine") << name;
    for (const auto& name : left) EXPECT_FALSE(fs::exists(study.result(name))) << name;
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

TEST(SeveralSeries, AreNotTakenAsOne) {
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12"));
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  const auto series = read_text(study.result("prony.csv"));
  const auto fit = test::run_breccia(study.path(), {"fit", "out/prony.csv"});
  EXPECT_EQ(fit.exit_code, 2);
  EXPECT_THAT(fit.errors, HasSubstr("out/prony.csv: results with several curves"));
  const auto run = study.breccia("check", {"--set", "materials.binder.shear={ prony = \"out/prony.csv\" }"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, HasSubstr("out/prony.csv: results with several curves"));
  // The rows of one series: those of the first test, up to the second infinite relaxation time.
  const auto second = series.find("inf", series.find("inf") + 1);
  study.write("one.csv", series.substr(0, series.rfind('\n', second) + 1));
  EXPECT_EQ(test::run_breccia(study.path(), {"fit", "one.csv"}).exit_code, 0);
}

TEST(EarlierFits, OfOtherOptionsOrDataAreNotReplacedUnasked) {
  const StudyDirectory study(test::good_deck);
  study.write("G.csv", "time_s,modulus_Pa\n1,3\n2,2\n3,1.5\n4,1.2\n");
  const auto fit = [&](const Words& more) {
    Words arguments = {"fit", "G.csv", "--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run_breccia(study.path(), arguments);
  };
  ASSERT_EQ(fit({}).exit_code, 0);
  EXPECT_EQ(fit({"--to", "relaxation", "--times-per-decade", "10"}).exit_code, 0) << "the same as by default";
  const auto creep = fit({"--to", "creep"});
  EXPECT_EQ(creep.exit_code, 2);
  EXPECT_THAT(creep.errors, HasSubstr("made of \"G.csv\", not of \"G.csv (--to creep)\"; replace it (--overwrite)"));
  const auto fewer = fit({"--times-per-decade", "3"});
  EXPECT_EQ(fewer.exit_code, 2);
  EXPECT_THAT(fewer.errors, HasSubstr("not of \"G.csv (--times-per-decade 3)\""));
  const auto before = read_text(study.result("prony.csv"));
  study.write("G.csv", "time_s,modulus_Pa\n1,30\n2,20\n3,15\n4,12\n");
  const auto edited = fit({});
  EXPECT_EQ(edited.exit_code, 2);
  EXPECT_THAT(edited.errors, HasSubstr("made of \"G.csv\", whose content was another then; replace it"));
  EXPECT_EQ(read_text(study.result("prony.csv")), before);
  EXPECT_EQ(fit({"--overwrite"}).exit_code, 0);
}

TEST_F(EarlierResults, OfAnotherResponseAreNotReplacedUnasked) {
  const std::string aged = "density = \"1.48 g/cm^3\"\nbulk = \"3.6 GPa\"\nshear = \"0.5 MPa\"\n";
  study_.write("aged.toml", aged);
  const auto respond = [&](const Words& more) {
    Words arguments = {"respond", "out", "--material", "aged.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run_breccia(study_.path(), arguments);
  };
  const auto first = respond({});
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_EQ(respond({}).exit_code, 0) << "the same once more";
  const auto shorter = respond({"--times", "1 ms", "10 ms"});
  EXPECT_EQ(shorter.exit_code, 2);
  EXPECT_THAT(shorter.errors, AllOf(HasSubstr("made of \"aged: A from 10 us to 100 ms, study "),
                                    HasSubstr("not of \"aged: A from 1 ms to 10 ms, study ")));
  const auto curves = read_text(study_.result("respond-aged/curves.csv"));
  study_.write("aged.toml", test::replaced(aged, "0.5 MPa", "0.6 MPa"));
  const auto edited = respond({});
  EXPECT_EQ(edited.exit_code, 2);
  EXPECT_THAT(edited.errors, HasSubstr("whose content was another then"));
  EXPECT_EQ(read_text(study_.result("respond-aged/curves.csv")), curves);
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
  EXPECT_THAT(
      other.errors,
      HasSubstr(R"(out: here is what `breccia fit` made of "G.csv", not of "H.csv"; replace it (--overwrite))"));
  EXPECT_EQ(read_text(study.result("prony.csv")), first);
  EXPECT_EQ(fit("H.csv", {"--overwrite"}).exit_code, 0);
  EXPECT_NE(read_text(study.result("prony.csv")), first);
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
