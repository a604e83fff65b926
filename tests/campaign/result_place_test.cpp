#include "campaign/result_place.hpp"

#include <filesystem>
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "campaign/checkpoints.hpp"
#include "campaign/deck_study.hpp"
#include "campaign/resume.hpp"
#include "messages.hpp"
#include "results/study_record.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Optional;

class ResultPlaceTest : public testing::Test {
 protected:
  /// The place for results, which is the directory itself.
  [[nodiscard]] ResultPlace place_of(const Study& one) const {
    return {one, results, [this] { return results; }};
  }

  Study study = test::study_of_deck("mine");
  test::TemporaryDirectory directory;
  const fs::path results = directory.path() / "results";
};

TEST_F(ResultPlaceTest, IsTheGroupsAloneAsLongAsItLives) {
  {
    const auto place = place_of(study);
    EXPECT_EQ(place.place(), results);
    EXPECT_THROW(DirectoryLock another(results), DirectoryInUse);
    EXPECT_THROW(static_cast<void>(place_of(study)), DirectoryInUse);
    EXPECT_TRUE(read_study_record(results).is_of(study)) << "who comes later is told what differs";
    test::leave(results, study, test::packed_result());
  }
  EXPECT_NO_THROW(DirectoryLock another(results));
  EXPECT_TRUE(fs::exists(results / "study.json")) << "a packing is a result";
}

TEST_F(ResultPlaceTest, DisappearsWithoutAResult) {
  static_cast<void>(place_of(study));
  EXPECT_FALSE(fs::exists(results)) << "a record alone is none";
}

TEST_F(ResultPlaceTest, KeepsARecordThatIsNotOfARunWithoutAResult) {
  const auto file = results / "study.json";
  fs::create_directories(results);
  write_text(file, R"({"mine": 1})");
  { const RemoveWithoutResult guard(results); }
  EXPECT_TRUE(fs::exists(file)) << "not of Breccia";
  write_provenance(results, study, test::packed_result());
  { const RemoveWithoutResult guard(results); }
  EXPECT_TRUE(fs::exists(file)) << "its packing may have been moved elsewhere";
  { const RemoveIfEmpty guard(results); }
  EXPECT_TRUE(fs::exists(file));
  write_provenance(results, study, {});
  { const RemoveWithoutResult guard(results); }
  EXPECT_FALSE(fs::exists(results));
}

TEST_F(ResultPlaceTest, PutsWhatIsBesideIntoThePlaceOfEarlierResults) {
  const auto other = test::study_of_deck("other");
  test::leave(results, other, test::complete_result());
  {
    const ResultPlace place(study, results, [this] {
      fs::create_directory(results / "unfinished");
      return results / "unfinished";
    });
    test::leave(place.place(), study, test::complete_result());
    EXPECT_TRUE(read_study_record(results).is_of(other));
    place.commit();
  }
  EXPECT_TRUE(read_study_record(results).is_of(study));
  EXPECT_FALSE(fs::exists(results / "unfinished"));
}

TEST_F(ResultPlaceTest, IsRefusedWithWhatTheChoiceThrows) {
  const auto refused = [&] {
    const ResultPlace place(study, results, []() -> fs::path { throw InputError("not here"); });
  };
  EXPECT_EQ(test::message_of<InputError>(refused), "not here");
  EXPECT_FALSE(fs::exists(results));
}

class CompleteRun : public ResultPlaceTest {
 protected:
  void write(const std::string& name) const { write_text(results / "fine" / name, ""); }
  [[nodiscard]] bool has(const std::string& name) const { return fs::exists(results / "fine" / name); }
};

TEST_F(CompleteRun, IsKnownByItsRecord) {
  EXPECT_EQ(time_of_complete_run(study, results), std::nullopt);
  EXPECT_FALSE(holds_tests(results));
  test::leave(results, study, test::tested_result());
  EXPECT_EQ(time_of_complete_run(study, results), std::nullopt);
  EXPECT_TRUE(holds_tests(results));
  test::leave(results, study, test::complete_result());
  EXPECT_THAT(time_of_complete_run(study, results), Optional(2.5));
  EXPECT_EQ(time_of_complete_run(test::study_of_deck("other"), results), std::nullopt);
}

// A run that was killed at its very end.
TEST_F(CompleteRun, IsDoneWithWhatWasLeftHalfDone) {
  test::leave(results, study, test::complete_result());
  write("packing.checkpoint.h5");
  write("modulus.svg.17.partial");
  EXPECT_THAT(take_over_complete_run(study, results), Optional(2.5));
  EXPECT_FALSE(has("packing.checkpoint.h5"));
  EXPECT_FALSE(has("modulus.svg.17.partial"));
  EXPECT_TRUE(has("modulus.svg"));
  EXPECT_TRUE(fs::exists(results / "report.html"));
}

TEST_F(CompleteRun, IsTakenFromWhatWasToReplaceEarlierResults) {
  test::leave(results, test::study_of_deck("other"), test::complete_result());
  test::leave(results / "unfinished", study, test::complete_result());
  EXPECT_THAT(take_over_complete_run(study, results), Optional(2.5));
  EXPECT_FALSE(fs::exists(results / "unfinished"));
}

TEST_F(CompleteRun, IsNotLookedForWhereThereIsNone) {
  EXPECT_EQ(take_over_complete_run(study, results), std::nullopt);
  EXPECT_FALSE(fs::exists(results));
  test::leave(results, study, test::tested_result());
  write("packing.checkpoint.h5");
  EXPECT_EQ(take_over_complete_run(study, results), std::nullopt);
  EXPECT_TRUE(has("packing.checkpoint.h5")) << "a run goes on from it";
  const DirectoryLock lock(results);
  EXPECT_THROW(static_cast<void>(take_over_complete_run(study, results)), DirectoryInUse);
}

// A file that is damaged after the run is computed again; the page, which is made of the others, is written again.
TEST_F(CompleteRun, IsNotTakenFromDamagedFiles) {
  test::leave(results, study, test::complete_result());
  close_results(study, results);
  EXPECT_THAT(take_over_complete_run(study, results), Optional(2.5));
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
      std::string note;
      RunObserver observer;
      observer.event = [&](const RunEvent& event) { note = std::get<Note>(event).text; };
      const auto time = take_over_complete_run(study, results, observer);
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
  EXPECT_THAT(take_over_complete_run(study, results), Optional(2.5));
  fs::remove(results / "fine" / "modulus.svg");
  EXPECT_EQ(take_over_complete_run(study, results), std::nullopt);
}

TEST_F(CompleteRun, IsNotTakenWhereItsChecksumsAreDamaged) {
  test::leave(results, study, test::complete_result());
  close_results(study, results);
  write_text(results / "checksums.txt", "");
  EXPECT_EQ(take_over_complete_run(study, results), std::nullopt);
  fs::remove(results / "checksums.txt");
  EXPECT_THAT(take_over_complete_run(study, results), Optional(2.5)) << "as results of earlier versions";
}

TEST_F(CompleteRun, RemovesTheCheckpointsOfItsStages) {
  test::leave(results, study, test::complete_result());
  EXPECT_THAT(checkpoint_files(study, results), testing::IsEmpty());
  for (const auto* name : {"packing.checkpoint.h5", "shear-displacement-dynamic-12.checkpoint.h5"}) write(name);
  EXPECT_THAT(checkpoint_files(study, results), testing::SizeIs(2));
  close_results(study, results);
  EXPECT_FALSE(has("packing.checkpoint.h5"));
  EXPECT_FALSE(has("shear-displacement-dynamic-12.checkpoint.h5"));
  EXPECT_TRUE(has("modulus.svg"));
}

}  // namespace
}  // namespace breccia
