#include "breccia/io/replacement.hpp"

#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"

#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

/// Old results of two stages with a note of the user, and new ones of two stages, one of which is new.
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
  std::vector<std::string> old_ = {"curves.csv", "study.json", "A/modulus.svg", "B/modulus.svg", "missing.csv"};
};

TEST_F(Replacement, PutsTheNewFilesIntoThePlaceOfTheOld) {
  replace_results(place_.path(), old_, "study.json");
  expect_the_new_results();
  finish_replacement(place_.path());
  expect_the_new_results();
}

TEST_F(Replacement, ResumesFromEveryPointOfInterruption) {
  // While old files were being removed, the record first.
  put("unfinished/removing.list", "study.json\ncurves.csv\nA/modulus.svg\nB/modulus.svg\n");
  put("unfinished/moving.list.17.partial", "stu");
  fs::remove(place_.path() / "study.json");
  finish_replacement(place_.path());
  expect_the_new_results();
}

TEST_F(Replacement, DoesNotRemoveFilesThatAreReplacedAlready) {
  // While new files were being moved.
  for (const auto* name : {"study.json", "curves.csv", "A/modulus.svg", "B/modulus.svg", "unfinished/B/modulus.svg"}) {
    fs::remove(place_.path() / name);
  }
  fs::remove(place_.path() / "A");
  put("B/modulus.svg", "new");
  put("unfinished/moving.list", "study.json\ncurves.csv\nA/modulus.svg\nB/modulus.svg\n");
  finish_replacement(place_.path());
  expect_the_new_results();
}

TEST_F(Replacement, CompletesIfOnlyItsListIsLeft) {
  replace_results(place_.path(), old_, "study.json");
  put("unfinished/moving.list", "study.json\n");
  fs::create_directory(place_.path() / "unfinished/B");
  finish_replacement(place_.path());
  expect_the_new_results();
}

TEST_F(Replacement, RefusesListsThatItDidNotWrite) {
  put("../victim.txt", "mine");
  for (const auto* list : {"study.json\n../victim.txt\n", "/etc/hostname\n", ""}) {
    put("unfinished/removing.list", list);
    EXPECT_THAT(test::message_of<FileError>([&] { finish_replacement(place_.path()); }),
                HasSubstr("removing.list: not as Breccia writes it"));
    EXPECT_EQ(read_text(place_.path() / "study.json"), "old");
  }
  fs::remove(place_.path() / "unfinished/removing.list");
  put("unfinished/moving.list", "");
  EXPECT_THROW(finish_replacement(place_.path()), FileError);
  EXPECT_EQ(read_text(place_.path() / "../victim.txt"), "mine");
  fs::remove(place_.path() / "../victim.txt");
}

TEST_F(Replacement, DoesNothingIfNoneWasBegun) {
  const auto before = files();
  finish_replacement(place_.path());
  EXPECT_EQ(files(), before);
}

TEST_F(Replacement, TouchesNothingWhereTheNewRecordHasDisappeared) {
  fs::remove(place_.path() / "unfinished/study.json");
  const auto before = files();
  EXPECT_THAT(test::message_of<FileError>([&] { replace_results(place_.path(), old_, "study.json"); }),
              HasSubstr("unfinished/study.json: has disappeared"));
  EXPECT_EQ(files(), before);
}

TEST_F(Replacement, MovesNothingFromBeyondTheDirectory) {
  const test::TemporaryDirectory elsewhere;
  elsewhere.write("data.csv", "mine");
  fs::create_directory(elsewhere.path() / "folder");
  elsewhere.write("folder/data.csv", "mine");
  fs::create_symlink(elsewhere.path() / "data.csv", place_.path() / "unfinished/data.csv");
  fs::create_directory_symlink(elsewhere.path() / "folder", place_.path() / "unfinished/folder");
  EXPECT_THAT(unfinished_files(place_.path()), testing::IsSupersetOf({"data.csv", "folder"}));
  put("unfinished/moving.list", "study.json\n");
  finish_replacement(place_.path());
  EXPECT_EQ(read_text(elsewhere.path() / "data.csv"), "mine");
  EXPECT_EQ(read_text(elsewhere.path() / "folder/data.csv"), "mine");
  EXPECT_TRUE(fs::is_symlink(place_.path() / "data.csv"));
  EXPECT_FALSE(fs::exists(place_.path() / "unfinished"));
}

TEST_F(Replacement, KeepsADirectoryThatIsALink) {
  const test::TemporaryDirectory disk;
  fs::remove_all(place_.path() / "A");
  fs::create_directory_symlink(disk.path(), place_.path() / "A");
  put("A/modulus.svg", "old");
  put("unfinished/A/modulus.svg", "new");
  replace_results(place_.path(), old_, "study.json");
  EXPECT_TRUE(fs::is_symlink(place_.path() / "A"));
  EXPECT_EQ(read_text(disk.path() / "modulus.svg"), "new");
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
  EXPECT_THAT(test::message_of<FileError>([&] { replace_results(place_.path(), old_, "study.json"); }),
              HasSubstr("C/modulus.svg: not written by Breccia"));
  EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace breccia
