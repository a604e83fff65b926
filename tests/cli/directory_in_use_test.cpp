// Tests of commands in a directory to which another process writes: they are refused, and change no file there.

#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "good_deck.hpp"
#include "io/directory_lock.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "study_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using test::StudyDirectory;
using testing::HasSubstr;
using Words = std::vector<std::string>;

/// This test is the other process.
class DirectoryOfAnotherProcess : public testing::Test {
 protected:
  [[nodiscard]] std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const auto& name : study_.results()) all[name] = read_text(study_.result(name));
    return all;
  }
  /// Writes the files of the other process so far: all of its results, still under temporary names.
  void write_unfinished(const std::string& directory) const {
    const auto whole = study_.result(directory);
    const auto copy = study_.path() / "copy";
    fs::copy(whole, copy, fs::copy_options::recursive);
    fs::rename(copy, whole / "unfinished");
    study_.write(fs::path("out") / directory / "unfinished/curves.csv.17.partial", "time");
  }
  void expect_refusal_in(const std::string& directory, const Words& command) const {
    const DirectoryLock lock(study_.result(directory));
    const auto before = contents();
    const auto outcome = test::run_breccia(study_.path(), command);
    EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(command) << outcome.output;
    EXPECT_THAT(outcome.errors, HasSubstr("another process of Breccia writes its results here"))
        << testing::PrintToString(command);
    if (command.front() != "report") {
      EXPECT_THAT(outcome.errors, HasSubstr("wait for its end, or take another directory (--out)"));
    }
    EXPECT_EQ(contents(), before) << testing::PrintToString(command);
  }

  const StudyDirectory study_{test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12")};
  const Words seeds_ = {"--sweep", "stages.A.packing.seed=[1, 2]"};
};

TEST_F(DirectoryOfAnotherProcess, IsLeftAloneByRunsAndPackings) {
  ASSERT_EQ(study_.breccia("run").exit_code, 0);
  write_unfinished("");
  for (const Words& command :
       {Words{"run"}, {"run", "--resume"}, {"run", "--overwrite"}, {"pack"}, {"pack", "--resume"}}) {
    expect_refusal_in("", StudyDirectory::arguments(command[0], {command.begin() + 1, command.end()}));
  }
}

TEST_F(DirectoryOfAnotherProcess, IsLeftAloneByFitsAndResponses) {
  study_.write("G.csv", "time_s,modulus_Pa\n1,3\n2,2\n3,1.5\n4,1.2\n");
  const Words fit = {"fit", "G.csv", "--out", "out"};
  ASSERT_EQ(test::run_breccia(study_.path(), fit).exit_code, 0);
  write_unfinished("");
  expect_refusal_in("", fit);
  fs::remove_all(study_.result(""));
  ASSERT_EQ(study_.breccia("run").exit_code, 0);
  study_.write("aged.toml", "density = \"1.48 g/cm^3\"\nbulk = \"3.6 GPa\"\nshear = \"0.5 MPa\"\n");
  const Words respond = {"respond", "out", "--material", "aged.toml"};
  ASSERT_EQ(test::run_breccia(study_.path(), respond).exit_code, 0);
  write_unfinished("respond-aged");
  expect_refusal_in("respond-aged", respond);
}

TEST_F(DirectoryOfAnotherProcess, IsLeftAloneByReports) {
  ASSERT_EQ(study_.breccia("run").exit_code, 0);
  fs::remove(study_.result("report.html"));
  const Words report = {"report", "out"};
  expect_refusal_in("", report);
  const DirectoryLock lock(study_.result(""));
  EXPECT_THAT(test::run_breccia(study_.path(), report).errors, testing::EndsWith("wait for its end\n"))
      << "a report has no other directory";
}

TEST_F(DirectoryOfAnotherProcess, HasUnfinishedResultsThatAreLeftAloneToo) {
  ASSERT_EQ(study_.breccia("run").exit_code, 0);
  fs::rename(study_.result(""), study_.path() / "whole");
  ASSERT_EQ(study_.breccia("run", {"--set", "stages.A.cells=10"}).exit_code, 0);
  fs::rename(study_.path() / "whole", study_.result("unfinished"));
  fs::remove(study_.result("unfinished/report.html"));
  for (const auto* directory : {"out/unfinished", "out/unfinished/", "./out/../out/unfinished"}) {
    expect_refusal_in("", {"report", directory});
  }
  EXPECT_EQ(test::run_breccia(study_.path(), {"report", "out/unfinished"}).exit_code, 0);

  study_.write("aged.toml", "density = \"1.48 g/cm^3\"\nbulk = \"3.6 GPa\"\nshear = \"0.5 MPa\"\n");
  Words respond = {"respond", "out/unfinished", "--material", "aged.toml"};
  const auto before = contents();
  const auto outcome = test::run_breccia(study_.path(), respond);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.errors,
            "out/unfinished/respond-aged: the results in out/unfinished are not finished, and other files there would "
            "prevent their run from being resumed; take another directory (--out)\n");
  EXPECT_EQ(contents(), before);
  respond.insert(respond.end(), {"--out", "aged"});
  EXPECT_EQ(test::run_breccia(study_.path(), respond).exit_code, 0);
}

TEST_F(DirectoryOfAnotherProcess, EndsASweepAndIsNoFailureOfATask) {
  ASSERT_EQ(study_.breccia("run", seeds_).exit_code, 0);
  write_unfinished("seed-2");
  for (const Words& option : {Words{}, {"--resume"}, {"--overwrite"}}) {
    auto more = seeds_;
    more.insert(more.end(), option.begin(), option.end());
    expect_refusal_in("", StudyDirectory::arguments("run", more));
    expect_refusal_in("seed-2", StudyDirectory::arguments("run", more));
  }
  expect_refusal_in("", StudyDirectory::arguments("pack", seeds_));
  expect_refusal_in("seed-2", StudyDirectory::arguments("pack", seeds_));
}

TEST_F(DirectoryOfAnotherProcess, EndsASweepWithATaskInIt) {
  // A process that begins in the directory of the second task while the first one runs.
  auto more = seeds_;
  more.insert(more.end(), {"--set", "stages.A.cells=120"});
  test::RunningCommand sweep(study_.path(), StudyDirectory::arguments("run", more));
  ASSERT_TRUE(sweep.reaches([&] { return fs::exists(study_.result("seed-1/study.json")); }));
  fs::create_directory(study_.result("seed-2"));
  study_.write("out/seed-2/notes.txt", "mine");
  const DirectoryLock lock(study_.result("seed-2"));
  const auto outcome = sweep.wait();
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_THAT(outcome.errors, HasSubstr("out/seed-2: another process of Breccia writes its results here"));
  EXPECT_THAT(read_text(study_.result("sweep.json")),
              testing::AllOf(HasSubstr("waiting"), testing::Not(HasSubstr("failed"))));
}

TEST(DirectoryThatIsALink, RemainsALink) {
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12"));
  fs::create_directory(study.path() / "disk");
  fs::create_directory_symlink("disk", study.path() / "out");
  const Words jams = {"--set", "stages.A.filler.fraction=0.8", "--overwrite"};
  EXPECT_EQ(study.breccia("run", jams).exit_code, 3);
  EXPECT_TRUE(fs::is_symlink(study.path() / "out"));
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(study.path() / "out"));
}

// A directory of results may come from someone else.
TEST(DirectoryThatIsALink, IsRefusedForAStage) {
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12"));
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  fs::rename(study.result("A"), study.path() / "stage");
  fs::create_directory_symlink("../stage", study.result("A"));
  for (const Words& options : {Words{}, {"--overwrite"}}) {
    const auto run = study.breccia("run", options);
    EXPECT_EQ(run.exit_code, 2) << run.output;
    EXPECT_EQ(run.errors,
              "out/A: a symbolic link, through which files elsewhere would be written or removed; remove it\n");
  }
  EXPECT_TRUE(fs::exists(study.path() / "stage/microstructure.csv"));
}

TEST(DirectoryThatIsEmpty, KeepsItsPermissions) {
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "cells   = 60", "cells   = 12"));
  fs::create_directory(study.path() / "out");
  fs::permissions(study.path() / "out", fs::perms::owner_all);
  ASSERT_EQ(study.breccia("run", {"--resume"}).exit_code, 0);
  EXPECT_EQ(fs::status(study.path() / "out").permissions(), fs::perms::owner_all);
}

}  // namespace
}  // namespace breccia
