#include "io/whole_results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class WholeResultsTest : public testing::Test {
 protected:
  [[nodiscard]] ResultsOrigin origin(const std::string& identity = "a") const {
    return {.command = "fit", .source = "G.csv", .identity = identity, .files = {"prony.csv", "fit.csv"}};
  }
  void make(const std::string& identity, const std::string& text) const {
    WholeResults results(directory(), origin(identity));
    write_text(results.place() / "prony.csv", text);
    results.commit();
  }
  [[nodiscard]] fs::path directory() const { return place_.path() / "out"; }

  test::TemporaryDirectory place_;
};

TEST_F(WholeResultsTest, ReplaceResultsOfTheSameOrigin) {
  make("a", "first");
  make("a", "second");
  EXPECT_EQ(read_text(directory() / "prony.csv"), "second");
  EXPECT_FALSE(fs::exists(directory() / "unfinished"));
  EXPECT_THROW(make("b", "third"), InputError);
  EXPECT_EQ(read_text(directory() / "prony.csv"), "second");
}

TEST_F(WholeResultsTest, LeaveNothingWithoutCommit) {
  {
    WholeResults results(directory(), origin());
    write_text(results.place() / "prony.csv", "half");
  }
  EXPECT_FALSE(fs::exists(directory()));
}

TEST_F(WholeResultsTest, CompleteTheResultsOfAKilledCommand) {
  fs::create_directories(directory() / "unfinished");
  write_text(directory() / "unfinished/fit.json", R"({"program": "breccia"})");
  write_text(directory() / "unfinished/fit.csv", "half");
  make("a", "whole");
  EXPECT_EQ(read_text(directory() / "prony.csv"), "whole");
  EXPECT_FALSE(fs::exists(directory() / "fit.csv"));
}

TEST_F(WholeResultsTest, TouchNoFilesOfOthers) {
  fs::create_directories(directory() / "unfinished");
  write_text(directory() / "unfinished/fit.csv", "mine");
  EXPECT_THAT(test::message_of<InputError>([&] { make("a", "new"); }),
              HasSubstr("out/unfinished/fit.csv: in the way of unfinished results"));
  EXPECT_EQ(read_text(directory() / "unfinished/fit.csv"), "mine");
}

TEST_F(WholeResultsTest, SurviveAFailureWhileTheyArePutInPlace) {
  make("a", "first");
  {
    WholeResults results(directory(), origin("a"));
    write_text(results.place() / "prony.csv", "second");
    write_text(results.place() / "fit.csv", "second");
    fs::create_directories(directory() / "fit.csv/in-the-way");
    EXPECT_THROW(results.commit(), FileError);
  }
  fs::remove_all(directory() / "fit.csv");
  const bool is_first = fs::exists(directory() / "prony.csv") && read_text(directory() / "prony.csv") == "first";
  const auto unfinished = directory() / "unfinished/prony.csv";
  const bool is_second = fs::exists(unfinished) && read_text(unfinished) == "second";
  EXPECT_TRUE(is_first || is_second);
  make("a", "third");
  EXPECT_EQ(read_text(directory() / "prony.csv"), "third");
}

TEST_F(WholeResultsTest, AreRefusedIfADirectoryIsInTheWay) {
  make("a", "first");
  fs::create_directories(directory() / "fit.csv");
  EXPECT_THAT(test::message_of<InputError>([&] { const WholeResults results(directory(), origin("a")); }),
              HasSubstr("out: directories are where the results are to be, fit.csv"));
  EXPECT_EQ(read_text(directory() / "prony.csv"), "first");
}

TEST_F(WholeResultsTest, AreMadeByOneProcessAtATime) {
  WholeResults results(directory(), origin("a"));
  write_text(results.place() / "prony.csv", "first");
  EXPECT_THROW(make("a", "second"), DirectoryInUse);
  results.commit();
  EXPECT_EQ(read_text(directory() / "prony.csv"), "first");
}

TEST_F(WholeResultsTest, AreRefusedWhereALinkIsInTheirPlace) {
  make("a", "first");
  fs::remove(directory() / "prony.csv");
  fs::create_symlink("prony.csv", directory() / "prony.csv");
  EXPECT_THAT(test::message_of<ConflictingResults>([&] { make("a", "new"); }),
              HasSubstr("out/prony.csv: a symbolic link, through which files elsewhere would be written or removed"));
  EXPECT_FALSE(fs::exists(directory() / "unfinished"));
}

// The directory may come from someone else.
TEST_F(WholeResultsTest, CarryOutNoListOfOthers) {
  make("a", "first");
  write_text(directory() / "notes.txt", "mine");
  fs::create_directories(directory() / "unfinished");
  const auto list = directory() / "unfinished/removing.list";
  for (const auto* text : {"fit.json\nnotes.txt\n", "notes.txt\n", "study.json\nprony.csv\n"}) {
    write_text(list, text);
    EXPECT_THAT(test::message_of<ConflictingResults>([&] { make("a", "new"); }),
                HasSubstr("removing.list: not as Breccia writes it here; remove it"));
    EXPECT_EQ(read_text(directory() / "notes.txt"), "mine");
    EXPECT_EQ(read_text(directory() / "prony.csv"), "first");
  }
}

TEST_F(WholeResultsTest, ObjectBeforeAListIsCarriedOut) {
  make("a", "first");
  fs::create_directories(directory() / "unfinished");
  write_text(directory() / "unfinished/removing.list", "fit.json\nprony.csv\n");
  write_text(directory() / "unfinished/fit.json", R"({"program": "breccia", "identity": "b"})");
  EXPECT_THROW(make("a", "new"), ConflictingResults);
  EXPECT_EQ(read_text(directory() / "prony.csv"), "first");
  make("b", "second");
  EXPECT_EQ(read_text(directory() / "prony.csv"), "second");
}

TEST_F(WholeResultsTest, AreKeptWhereTheirEndCannotBeSeen) {
  const auto list = directory() / "unfinished/removing.list";
  {
    WholeResults results(directory(), origin());
    write_text(results.place() / "prony.csv", "new");
    fs::create_symlink("removing.list", list);
  }
  fs::remove(list);
  EXPECT_EQ(read_text(directory() / "unfinished/prony.csv"), "new");
}

TEST_F(WholeResultsTest, LeaveNoDirectoryWhereTheyCannotBegin) {
  fs::create_directories(directory() / "unfinished/fit.json");
  EXPECT_THROW(make("a", "new"), FileError) << "a directory is where the record is to be";
  EXPECT_FALSE(fs::exists(directory() / "unfinished"));
}

}  // namespace
}  // namespace breccia
