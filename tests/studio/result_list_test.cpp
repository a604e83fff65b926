#include "studio/result_list.hpp"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "io/text_file.hpp"
#include "temporary_directory.hpp"

namespace breccia::studio {
namespace {

namespace fs = std::filesystem;

void write_record(const fs::path& directory, const std::string& name, const std::string& text) {
  fs::create_directories(directory);
  write_text(directory / name, text);
}

TEST(ResultsIn, ListsRunsAndSweepsTheLatestFirst) {
  const test::TemporaryDirectory directory;
  const auto results = directory.path() / "results";
  write_record(results / "a", "study.json",
               R"({"title": "A", "deck": "a.toml", "deck_text": "x", "date": "2026-01-01T00:00:00Z", "complete": true,
                   "wall_time_s": 2.5})");
  write_record(results / "b", "study.json", R"({"title": "B", "date": "2026-01-02T00:00:00Z", "complete": false})");
  write_record(results / "c", "sweep.json", R"({"title": "C"})");
  write_text(results / "a" / "report.html", "");
  write_record(results / "broken", "study.json", "{");
  write_record(results / "fit", "fit.json", "{}");
  const auto list = results_in(Folder(directory.path()));
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0].path, "results/b");
  EXPECT_FALSE(list[0].is_complete);
  EXPECT_FALSE(list[0].has_page);
  EXPECT_EQ(list[1].path, "results/a");
  EXPECT_EQ(list[1].title, "A");
  EXPECT_EQ(list[1].deck, "a.toml");
  EXPECT_TRUE(list[1].is_complete);
  EXPECT_TRUE(list[1].has_page);
  EXPECT_EQ(list[1].seconds, 2.5);
  EXPECT_TRUE(list[2].is_sweep);
}

TEST(ResultsIn, ReadsNothingOutsideOfTheFolderAndNoPipe) {
  const test::TemporaryDirectory directory, outside;
  const auto results = directory.path() / "results";
  write_record(outside.path() / "other", "study.json", R"({"title": "outside"})");
  fs::create_directories(results / "pipe");
  ASSERT_EQ(::mkfifo((results / "pipe" / "study.json").c_str(), 0600), 0);
  fs::create_directory_symlink(outside.path() / "other", results / "link");
  EXPECT_TRUE(results_in(Folder(directory.path())).empty());
}

TEST(ResultsIn, FollowsALinkOfTheResultsAsAWhole) {
  const test::TemporaryDirectory directory, scratch;
  write_record(scratch.path() / "a", "study.json", R"({"title": "A"})");
  fs::create_directory_symlink(scratch.path(), directory.path() / "results");
  const Folder folder(directory.path());
  ASSERT_EQ(results_in(folder).size(), 1U);
  EXPECT_NO_THROW((void)folder.file("results/a/study.json"));
}

TEST(ResultsIn, IsEmptyWithoutResults) {
  const test::TemporaryDirectory directory;
  EXPECT_TRUE(results_in(Folder(directory.path())).empty());
}

TEST(DirectoryFor, GoesOnWithResultsOfTheSameTextAlone) {
  const test::TemporaryDirectory directory;
  const auto results = directory.path() / "results";
  EXPECT_EQ(directory_for(Folder(directory.path()), "a", "one"), "results/a");
  write_record(results / "a", "study.json", R"({"deck_text": "one", "overrides": []})");
  EXPECT_EQ(directory_for(Folder(directory.path()), "a", "one"), "results/a");
  EXPECT_EQ(directory_for(Folder(directory.path()), "a", "two"), "results/a-2");
  write_record(results / "a-2", "study.json", R"({"deck_text": "two", "overrides": ["tests.times=1"]})");
  EXPECT_EQ(directory_for(Folder(directory.path()), "a", "two"), "results/a-3");
  write_record(results / "a-3", "another.txt", "of someone else");
  EXPECT_EQ(directory_for(Folder(directory.path()), "a", "two"), "results/a-4");
  EXPECT_EQ(new_directory_for(Folder(directory.path()), "a"), "results/a-4");
  EXPECT_EQ(new_directory_for(Folder(directory.path()), "b"), "results/b");
}

}  // namespace
}  // namespace breccia::studio
