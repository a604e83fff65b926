#include "campaign/complete_run.hpp"

#include <filesystem>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "campaign/checkpoints.hpp"
#include "campaign/deck_study.hpp"
#include "campaign/result_transaction.hpp"
#include "results/study_document.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Optional;

class CompleteRunTest : public testing::Test {
 protected:
  void write(const std::string& name) const { write_text(results / "fine" / name, ""); }
  [[nodiscard]] bool has(const std::string& name) const { return fs::exists(results / "fine" / name); }
  /// What a run with `resume` finds first.
  [[nodiscard]] CompleteRun taken_over() const { return taken_over(study); }
  [[nodiscard]] CompleteRun taken_over(const Study& one) const {
    return ResultTransaction(one, results, {}).take_over();
  }
  void close() const { close_results(study, results, read_study_document(results)); }

  Study study = test::study_of_deck("mine");
  test::TemporaryDirectory directory;
  const fs::path results = directory.path() / "results";
};

TEST_F(CompleteRunTest, IsKnownByItsRecord) {
  EXPECT_EQ(taken_over().seconds, std::nullopt);
  test::leave(results, study, test::tested_result());
  EXPECT_EQ(taken_over().seconds, std::nullopt);
  test::leave(results, study, test::complete_result());
  EXPECT_THAT(taken_over().seconds, Optional(2.5));
  EXPECT_EQ(taken_over(test::study_of_deck("other")).seconds, std::nullopt);
}

// From one process to the others.
TEST_F(CompleteRunTest, IsTheSameAsAText) {
  const auto runs = complete_runs_in(text_of({{}, {0.1 + 0.2, {}}, {1e300, "a \"note\"\nof two lines"}}));
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].seconds, std::nullopt);
  EXPECT_EQ(runs[1].seconds, 0.1 + 0.2);
  EXPECT_EQ(runs[2].seconds, 1e300);
  EXPECT_EQ(runs[2].note, "a \"note\"\nof two lines");
}

// A run that was killed at its very end.
TEST_F(CompleteRunTest, IsDoneWithWhatWasLeftHalfDone) {
  test::leave(results, study, test::complete_result());
  write("packing.checkpoint.h5");
  write("modulus.svg.17.partial");
  EXPECT_THAT(taken_over().seconds, Optional(2.5));
  EXPECT_FALSE(has("packing.checkpoint.h5"));
  EXPECT_FALSE(has("modulus.svg.17.partial"));
  EXPECT_TRUE(has("modulus.svg"));
  EXPECT_TRUE(fs::exists(results / "report.html"));
}

TEST_F(CompleteRunTest, IsTakenFromWhatWasToReplaceEarlierResults) {
  test::leave(results, test::study_of_deck("other"), test::complete_result());
  test::leave(results / "unfinished", study, test::complete_result());
  EXPECT_THAT(taken_over().seconds, Optional(2.5));
  EXPECT_FALSE(fs::exists(results / "unfinished"));
}

TEST_F(CompleteRunTest, IsNotLookedForWhereThereIsNone) {
  EXPECT_EQ(taken_over().seconds, std::nullopt);
  EXPECT_FALSE(fs::exists(results));
  test::leave(results, study, test::tested_result());
  write("packing.checkpoint.h5");
  EXPECT_EQ(taken_over().seconds, std::nullopt);
  EXPECT_TRUE(has("packing.checkpoint.h5")) << "a run goes on from it";
  const DirectoryLock lock(results);
  EXPECT_THROW(static_cast<void>(taken_over()), DirectoryInUse);
}

// A file that is damaged after the run is computed again; the page, which is made of the others, is written again.
TEST_F(CompleteRunTest, IsNotTakenFromDamagedFiles) {
  test::leave(results, study, test::complete_result());
  close();
  EXPECT_THAT(taken_over().seconds, Optional(2.5));
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(results)) {
    const auto name = entry.path().lexically_relative(results).string();
    if (!entry.is_regular_file() || name == "study.json" || name == "checksums.txt") continue;
    ++files;
    const auto whole = read_text(entry.path());
    auto flipped = whole;
    flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 1);
    for (const auto& damaged : {std::string(), std::string(whole.size(), '\0'), whole.substr(1), flipped}) {
      write_text(entry.path(), damaged);
      const auto [time, note] = taken_over();
      if (name == "report.html") {
        EXPECT_THAT(time, Optional(2.5));
        EXPECT_EQ(read_text(entry.path()), whole);
      } else {
        EXPECT_EQ(time, std::nullopt) << name;
        EXPECT_EQ(note, results.string() + ": missing or changed since the run: " + name + "; it is computed again");
      }
    }
    write_text(entry.path(), whole);
  }
  EXPECT_GE(files, 4U);
  EXPECT_THAT(taken_over().seconds, Optional(2.5));
  fs::remove(results / "fine" / "modulus.svg");
  EXPECT_EQ(taken_over().seconds, std::nullopt);
}

TEST_F(CompleteRunTest, IsNotTakenWhereItsChecksumsAreDamaged) {
  test::leave(results, study, test::complete_result());
  close();
  write_text(results / "checksums.txt", "");
  EXPECT_EQ(taken_over().seconds, std::nullopt);
}

TEST_F(CompleteRunTest, IsTakenWithANoteWhereItsChecksumsAreMissing) {
  test::leave(results, study, test::complete_result());
  close();
  const auto checksums = read_text(results / "checksums.txt");
  fs::remove(results / "checksums.txt");
  const auto [time, note] = taken_over();
  EXPECT_THAT(time, Optional(2.5));
  EXPECT_EQ(note, results.string() +
                      ": missing since the run: checksums.txt, against which the other files cannot be checked now; it "
                      "is written anew for the files as they are");
  EXPECT_EQ(read_text(results / "checksums.txt"), checksums);
  EXPECT_EQ(taken_over().note, "");
}

TEST_F(CompleteRunTest, IsNotTakenWithoutChecksumsWhereItCannotBeRead) {
  test::leave(results, study, test::complete_result());
  close();
  fs::remove(results / "checksums.txt");
  const auto whole = read_text(results / "curves.csv");
  write_text(results / "curves.csv", whole.substr(0, whole.rfind(',')));
  const auto [time, note] = taken_over();
  EXPECT_EQ(time, std::nullopt);
  EXPECT_THAT(note, AllOf(HasSubstr(": missing since the run: checksums.txt, "), HasSubstr("curves.csv"),
                          EndsWith("; it is computed again")));
  EXPECT_FALSE(fs::exists(results / "checksums.txt"));
}

TEST_F(CompleteRunTest, RemovesTheCheckpointsOfItsStages) {
  test::leave(results, study, test::complete_result());
  EXPECT_THAT(checkpoint_files(study, results), testing::IsEmpty());
  for (const auto* name : {"packing.checkpoint.h5", "shear-displacement-dynamic-12.checkpoint.h5"}) write(name);
  EXPECT_THAT(checkpoint_files(study, results), testing::SizeIs(2));
  close();
  EXPECT_FALSE(has("packing.checkpoint.h5"));
  EXPECT_FALSE(has("shear-displacement-dynamic-12.checkpoint.h5"));
  EXPECT_TRUE(has("modulus.svg"));
}

}  // namespace
}  // namespace breccia
