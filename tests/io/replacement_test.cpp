#include "io/replacement.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

/// Old results of two stages with a note of the user, and new results of two stages, one of which is new.
class Replacement : public testing::Test {
 protected:
  Replacement() {
    put("study.json", "old");
    put("curves.csv", "old");
    put("A/modulus.svg", "old");
    put("B/modulus.svg", "old");
    put("B/notes.txt", "mine");
    put("unfinished/study.json", "new");
    put("unfinished/curves.csv", "new");
    put("unfinished/B/modulus.svg", "new");
    put("unfinished/C/modulus.svg", "new");
  }

  void put(const std::string& name, const std::string& text) const {
    fs::create_directories((place_.path() / name).parent_path());
    place_.write(name, text);
  }
  [[nodiscard]] std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(place_.path())) {
      if (entry.is_regular_file()) all[fs::relative(entry.path(), place_.path())] = read_text(entry.path());
    }
    return all;
  }
  void expect_the_new_results() const {
    EXPECT_THAT(files(),
                ElementsAre(Pair("B/modulus.svg", "new"), Pair("B/notes.txt", "mine"), Pair("C/modulus.svg", "new"),
                            Pair("curves.csv", "new"), Pair("study.json", "new")));
    EXPECT_FALSE(fs::exists(place_.path() / "A")) << "empty";
    EXPECT_FALSE(fs::exists(place_.path() / "unfinished"));
  }

  test::TemporaryDirectory place_;
  const ResultNames names_ = {"study.json", [](std::string_view name) {
                                return name == "study.json" || name == "curves.csv" || name == "missing.csv" ||
                                       name.ends_with("/modulus.svg");
                              }};
  std::vector<std::string> old_ = {"curves.csv", "study.json", "A/modulus.svg", "B/modulus.svg", "missing.csv"};
};

TEST_F(Replacement, PutsTheNewFilesIntoThePlaceOfTheOld) {
  replace_results(place_.path(), old_, names_);
  expect_the_new_results();
  finish_replacement(place_.path(), names_);
  expect_the_new_results();
}

TEST_F(Replacement, ResumesFromEveryPointOfInterruption) {
  // The replacement was interrupted while it removed old files, the record first.
  put("unfinished/removing.list", "study.json\ncurves.csv\nA/modulus.svg\nB/modulus.svg\n");
  put("unfinished/moving.list.17.partial", "stu");
  fs::remove(place_.path() / "study.json");
  finish_replacement(place_.path(), names_);
  expect_the_new_results();
}

TEST_F(Replacement, DoesNotRemoveFilesThatAreReplacedAlready) {
  // The replacement was interrupted while it moved new files.
  for (const auto* name : {"study.json", "curves.csv", "A/modulus.svg", "B/modulus.svg", "unfinished/B/modulus.svg"}) {
    fs::remove(place_.path() / name);
  }
  fs::remove(place_.path() / "A");
  put("B/modulus.svg", "new");
  put("unfinished/moving.list", "study.json\ncurves.csv\nA/modulus.svg\nB/modulus.svg\n");
  finish_replacement(place_.path(), names_);
  expect_the_new_results();
}

TEST_F(Replacement, CompletesIfOnlyItsListIsLeft) {
  replace_results(place_.path(), old_, names_);
  put("unfinished/moving.list", "study.json\n");
  fs::create_directory(place_.path() / "unfinished/B");
  finish_replacement(place_.path(), names_);
  expect_the_new_results();
}

TEST_F(Replacement, RefusesListsThatItDidNotWrite) {
  put("../victim.txt", "mine");
  put("notes.txt", "mine");
  for (const auto* list : {"study.json\n../victim.txt\n", "/etc/hostname\n", "", "study.json\nnotes.txt\n",
                           "study.json\nB/notes.txt\n", "curves.csv\n", "study.json\n\n"}) {
    put("unfinished/removing.list", list);
    EXPECT_THAT(test::message_of<FileError>([&] { finish_replacement(place_.path(), names_); }),
                HasSubstr("removing.list: not as Breccia writes it"));
    EXPECT_EQ(read_text(place_.path() / "study.json"), "old");
  }
  fs::remove(place_.path() / "unfinished/removing.list");
  put("unfinished/moving.list", "");
  EXPECT_THROW(finish_replacement(place_.path(), names_), FileError);
  EXPECT_EQ(read_text(place_.path() / "../victim.txt"), "mine");
  fs::remove(place_.path() / "../victim.txt");
}

TEST_F(Replacement, DoesNothingIfNoneWasBegun) {
  const auto before = files();
  finish_replacement(place_.path(), names_);
  EXPECT_EQ(files(), before);
}

TEST_F(Replacement, TouchesNothingWhereTheNewRecordHasDisappeared) {
  fs::remove(place_.path() / "unfinished/study.json");
  const auto before = files();
  EXPECT_THAT(test::message_of<FileError>([&] { replace_results(place_.path(), old_, names_); }),
              HasSubstr("unfinished/study.json: has disappeared"));
  EXPECT_EQ(files(), before);
}

// A list from someone else may name a file behind a link.
TEST_F(Replacement, RemovesNothingBeyondALink) {
  const test::TemporaryDirectory victim;
  victim.write("modulus.svg", "mine");
  fs::create_directory_symlink(victim.path(), place_.path() / "link");
  put("unfinished/removing.list", "study.json\nlink/modulus.svg\n");
  EXPECT_THAT(
      test::message_of<FileError>([&] { finish_replacement(place_.path(), names_); }),
      HasSubstr((place_.path() / "link").string() + ": a symbolic link, through which files elsewhere would be"));
  EXPECT_EQ(read_text(victim.path() / "modulus.svg"), "mine");
  EXPECT_EQ(read_text(place_.path() / "study.json"), "old");
}

TEST_F(Replacement, WritesNothingBeyondALink) {
  const test::TemporaryDirectory victim;
  victim.write("modulus.svg", "mine");
  fs::create_directory_symlink(victim.path(), place_.path() / "link");
  put("unfinished/moving.list", "study.json\ncurves.csv\nB/modulus.svg\n");
  fs::create_directory(place_.path() / "unfinished/link");
  put("unfinished/link/modulus.svg", "new");
  EXPECT_THROW(finish_replacement(place_.path(), names_), FileError);
  EXPECT_EQ(read_text(victim.path() / "modulus.svg"), "mine");
  EXPECT_EQ(read_text(place_.path() / "curves.csv"), "old");
}

TEST_F(Replacement, MovesNoLinks) {
  const test::TemporaryDirectory elsewhere;
  elsewhere.write("data.csv", "mine");
  fs::remove(place_.path() / "unfinished/curves.csv");
  fs::create_symlink(elsewhere.path() / "data.csv", place_.path() / "unfinished/curves.csv");
  fs::create_directory_symlink(elsewhere.path(), place_.path() / "unfinished/folder");
  EXPECT_THAT(unfinished_files(place_.path()), testing::IsSupersetOf({"curves.csv", "folder"}));
  for (const auto* list : {"unfinished/removing.list", "unfinished/moving.list"}) {
    put(list, "study.json\ncurves.csv\nB/modulus.svg\n");
    EXPECT_THAT(test::message_of<FileError>([&] { finish_replacement(place_.path(), names_); }),
                HasSubstr("unfinished/curves.csv: a symbolic link"));
    fs::remove(place_.path() / list);
  }
  EXPECT_THROW(replace_results(place_.path(), old_, names_), FileError);
  EXPECT_EQ(read_text(elsewhere.path() / "data.csv"), "mine");
  EXPECT_EQ(read_text(place_.path() / "curves.csv"), "old");
}

TEST_F(Replacement, MovesNoFilesOfOtherNames) {
  put("unfinished/.bashrc", "bad");
  put("unfinished/link/.bashrc", "bad");
  replace_results(place_.path(), old_, names_);
  EXPECT_FALSE(fs::exists(place_.path() / ".bashrc"));
  EXPECT_FALSE(fs::exists(place_.path() / "link"));
  EXPECT_EQ(read_text(place_.path() / "curves.csv"), "new");
  EXPECT_TRUE(fs::exists(place_.path() / "unfinished/link/.bashrc"));
}

TEST_F(Replacement, ReplacesNoFileThatItsListDoesNotName) {
  put("C/modulus.svg", "mine");
  put("unfinished/removing.list", "study.json\ncurves.csv\nB/modulus.svg\n");
  EXPECT_THAT(test::message_of<FileError>([&] { finish_replacement(place_.path(), names_); }),
              HasSubstr("C/modulus.svg: not written by Breccia, so it is not replaced"));
  EXPECT_EQ(read_text(place_.path() / "C/modulus.svg"), "mine");
  EXPECT_EQ(read_text(place_.path() / "study.json"), "old");
}

TEST_F(Replacement, ListsUnfinishedFilesAndTouchesNone) {
  put("unfinished/notes.partial", "mine");
  put("unfinished/curves.csv.17.partial", "of a process");
  put("unfinished/B/modulus.svg.17.partial", "of a process");
  const auto before = files();
  EXPECT_THAT(unfinished_files(place_.path()),
              ElementsAre("B/modulus.svg", "C/modulus.svg", "curves.csv", "notes.partial", "study.json"));
  EXPECT_EQ(files(), before);
}

TEST_F(Replacement, TouchesNothingWhereAFileIsNotAmongTheOldOnes) {
  put("C/modulus.svg", "mine");
  const auto before = files();
  EXPECT_THAT(test::message_of<FileError>([&] { replace_results(place_.path(), old_, names_); }),
              HasSubstr("C/modulus.svg: not written by Breccia"));
  EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace breccia
