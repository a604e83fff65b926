#include "io/text_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/partial_name.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

std::size_t count_files(const std::filesystem::path& directory) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(directory), std::filesystem::directory_iterator()));
}

TEST(TextFile, RoundTripKeepsEveryByte) {
  const test::TemporaryDirectory directory;
  const std::string text("a\r\nb\0c\n", 7);
  write_text(directory.path() / "file", text);
  EXPECT_EQ(read_text(directory.path() / "file"), text);
  EXPECT_EQ(count_files(directory.path()), 1U);
}

TEST(TextFile, BeginningOfAFileIsNoLongerThanTheFile) {
  const test::TemporaryDirectory directory;
  const auto path = directory.written("file", std::string(100000, 'a') + "b");
  EXPECT_EQ(read_beginning(path, 3), "aaa");
  EXPECT_EQ(read_beginning(path, 0), "");
  EXPECT_EQ(read_beginning(path, 100001), read_text(path));
  EXPECT_EQ(read_beginning(path, 200000).size(), 100001U);
}

TEST(TextFile, AStreamWithoutAnEndIsRefused) {
  const auto refusal = test::message_of<FileError>([] { static_cast<void>(read_text("/dev/zero")); });
  EXPECT_THAT(refusal,
              testing::HasSubstr("/dev/zero: cannot read: it is no regular file, and does not end within 268 MB"));
  EXPECT_EQ(read_text("/dev/null"), "");
}

TEST(TextFile, WritingReplacesAnOlderFile) {
  const test::TemporaryDirectory directory;
  const auto path = directory.written("file", "old");
  write_text(path, "new");
  EXPECT_EQ(read_text(path), "new");
}

TEST(TextFile, ErrorsNameTheFileAndTheReason) {
  const test::TemporaryDirectory directory;
  const auto missing = directory.path() / "no" / "file";
  const auto written = test::message_of<FileError>([&] { write_text(missing, "x"); });
  EXPECT_EQ(written, missing.string() + ": cannot write: No such file or directory");
  const auto read = test::message_of<FileError>([&] { static_cast<void>(read_text(missing)); });
  EXPECT_EQ(read, missing.string() + ": cannot read: No such file or directory");
  const auto folder = test::message_of<FileError>([&] { static_cast<void>(read_text(directory.path())); });
  EXPECT_THAT(folder, testing::HasSubstr("is a directory"));
  const auto loop = directory.path() / "loop";
  std::filesystem::create_symlink("loop", loop);
  const auto endless = test::message_of<FileError>([&] { static_cast<void>(read_text(loop)); });
  EXPECT_THAT(endless, testing::StartsWith(loop.string() + ": cannot be looked at: "));
}

TEST(TextFile, AFullDiskIsAnErrorAndLeavesTheOldFile) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  const test::TemporaryDirectory directory;
  const auto path = directory.written("file", "old");
  const AtomicFile plan(path);
  std::filesystem::create_symlink("/dev/full", plan.temporary());
  EXPECT_THROW(write_text(path, "new"), FileError);
  EXPECT_EQ(read_text(path), "old");
}

TEST(AtomicFile, DisappearsWithoutCommit) {
  const test::TemporaryDirectory directory;
  {
    const AtomicFile file(directory.path() / "file");
    std::ofstream(file.temporary()) << "half";
    EXPECT_EQ(count_files(directory.path()), 1U);
  }
  EXPECT_EQ(count_files(directory.path()), 0U);
}

// Reference values of XXH64 with seed 0, from the specification's own test vectors.
TEST(ContentHash, IsXxHash64) {
  EXPECT_EQ(content_hash(""), "ef46db3751d8e999");
  EXPECT_EQ(content_hash("abc"), "44bc2cf5ad770999");
}

TEST(PartialFiles, AreKnownByTheNumberOfTheirProcess) {
  EXPECT_EQ(partial_name("out/curves.csv", 17), "out/curves.csv.17.partial");
  for (const auto* name : {"curves.csv.17.partial", "A/curves.csv.17.partial"}) {
    EXPECT_TRUE(is_partial_name(name)) << name;
    EXPECT_EQ(partial_name(whole_name(name), 17), name);
  }
  for (const auto* name : {"curves.csv", "notes.partial", "notes.v2.partial", "notes..partial", ".17.partial",
                           "A/.17.partial", "17.partial", ".partial", "curves.csv.17.partial.txt", ""}) {
    EXPECT_FALSE(is_partial_name(name)) << name;
    EXPECT_EQ(whole_name(name), "");
  }
}

TEST(PartialFiles, OfOthersAreNotRemoved) {
  const test::TemporaryDirectory directory;
  for (const auto* name : {"curves.csv.17.partial", "data.12.partial", "notes.partial", "curves.csv"}) {
    directory.write(name, "text");
  }
  remove_partial_files(directory.path(), [](std::string_view name) { return name == "curves.csv"; });
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "curves.csv.17.partial"));
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "data.12.partial"));
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "notes.partial"));
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "curves.csv"));
}

}  // namespace
}  // namespace breccia
