#include "results/checksums.hpp"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/seal.hpp"
#include "io/text_file.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;
using testing::StartsWith;
using testing::UnorderedElementsAre;

class Checksums : public testing::Test {
 protected:
  Checksums() {
    std::filesystem::create_directory(directory.path() / "A");
    directory.write("curves.csv", "time_s,modulus_Pa\n");
    directory.write("study.json", "{}");
    directory.write("notes.txt", "mine");
    directory.write("A/response.h5", "");
    directory.write("A/packing.checkpoint.h5", "");
    write_checksums(directory.path(), {"A"});
  }

  test::TemporaryDirectory directory;
};

TEST_F(Checksums, AreThoseOfXxhsum) {
  // The hashes were computed by `xxhsum -H1`.
  EXPECT_THAT(read_text(directory.path() / "checksums.txt"),
              StartsWith("126b170749e92aab  curves.csv\n"
                         "2e1472b57af294d1  study.json\n"
                         "ef46db3751d8e999  A/response.h5\n\nbreccia seal"));
}

TEST_F(Checksums, TellWhatHasChanged) {
  EXPECT_THAT(damaged_files(directory.path()), Optional(IsEmpty()));
  directory.write("curves.csv", "");
  std::filesystem::remove(directory.path() / "A/response.h5");
  EXPECT_THAT(damaged_files(directory.path()), Optional(UnorderedElementsAre("curves.csv", "A/response.h5")));
  EXPECT_THAT(unchanged_files(directory.path()), UnorderedElementsAre("study.json", "checksums.txt"));
}

TEST_F(Checksums, TellNothingWhereTheyAreMissingOrDamaged) {
  const auto file = directory.path() / "checksums.txt";
  directory.write("checksums.txt", read_text(file).substr(1));
  EXPECT_THAT(damaged_files(directory.path()), Optional(ElementsAre("checksums.txt")));
  EXPECT_THAT(unchanged_files(directory.path()), IsEmpty());
  std::filesystem::remove(file);
  EXPECT_EQ(damaged_files(directory.path()), std::nullopt);
  EXPECT_THAT(unchanged_files(directory.path()), IsEmpty());
}

TEST_F(Checksums, ReachNoFileOfOtherNames) {
  directory.write("checksums.txt", sealed("0000000000000000  notes.txt\n0000000000000000  ../A/response.h5\n"));
  EXPECT_THAT(damaged_files(directory.path()), Optional(IsEmpty()));
}

}  // namespace
}  // namespace breccia
