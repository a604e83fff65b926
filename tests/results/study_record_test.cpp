#include "results/study_record.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "results/hand_made_results.hpp"
#include "results/provenance.hpp"
#include "study/identity.hpp"
#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Study study_of_a_deck() {
  auto study = test::two_stages();
  study.provenance.deck = "deck.toml";
  study.provenance.deck_text = "title = \"a\"\n[tests]\ntimes = 1\n";
  study.provenance.overrides = {"stages.0.cells=12", "tests.method=\"quasistatic\""};
  study.provenance.hash = "0123456789abcdef";
  study.provenance.content = content_of(study);
  return study;
}

class StudyRecordFile : public testing::Test {
 protected:
  [[nodiscard]] StudyRecord record_of(const StudyResult& result) const {
    write_provenance(directory.path(), study, result);
    return read_study_record(directory.path());
  }
  [[nodiscard]] StudyRecord record_with(const std::string& text) const {
    directory.write("study.json", text);
    return read_study_record(directory.path());
  }

  test::TemporaryDirectory directory;
  Study study = study_of_a_deck();
};

TEST_F(StudyRecordFile, TellsHowFarARunHasCome) {
  const auto begun = record_of({});
  EXPECT_TRUE(begun.is_ours);
  EXPECT_TRUE(begun.is_of(study));
  EXPECT_FALSE(begun.is_complete);
  EXPECT_FALSE(begun.has_tests);
  EXPECT_THAT(begun.stages, ElementsAre("fine", "coarse"));
  EXPECT_THAT(begun.stages_packed, IsEmpty());

  const auto packed = record_of({{test::stage_with("fine", {})}, {}});
  EXPECT_FALSE(packed.has_tests);
  EXPECT_THAT(packed.stages_packed, ElementsAre("fine"));

  const auto tested = test::stage_with("fine", {test::test_with({.grid = TestGrid(12)}, {{1.0, 1.0}})});
  const auto unfinished = record_of({{tested}, {}});
  EXPECT_TRUE(unfinished.has_tests);
  EXPECT_FALSE(unfinished.is_complete_run_of(study));

  const auto complete = record_of({{tested}, 12.5});
  EXPECT_TRUE(complete.is_complete_run_of(study));
  EXPECT_EQ(complete.wall_time, 12.5);
}

TEST_F(StudyRecordFile, TellsWhichStudyItIsOf) {
  const auto record = record_of({});
  EXPECT_EQ(record.hash, "0123456789abcdef");
  EXPECT_EQ(record.version, BRECCIA_VERSION);
  EXPECT_EQ(record.deck_text, study.provenance.deck_text);
  EXPECT_EQ(record.overrides, study.provenance.overrides);
  auto other = study;
  other.provenance.hash = "fedcba9876543210";
  EXPECT_FALSE(record.is_of(other));
  auto of_another_version = record;
  of_another_version.version = "0.0.1";
  EXPECT_FALSE(of_another_version.is_of(study));
}

TEST_F(StudyRecordFile, TellsTheFirstDifferenceOfTwoStudies) {
  const auto record = record_of({});
  auto now = study;
  EXPECT_EQ(difference(record, now), "a data file differs") << "nothing else does";
  now.provenance.overrides = {"stages.0.cells=13"};
  EXPECT_EQ(difference(record, now),
            R"(the overrides were ["stages.0.cells=12","tests.method=\"quasistatic\""], are ["stages.0.cells=13"])");
  now.provenance.deck_text = "title = \"a\"\n[tests]\ntimes = 2\n";
  EXPECT_EQ(difference(record, now),
            R"(deck.toml: line 3 was `times = 1`, is `times = 2`; the overrides were ["stages.0.cells=12",)"
            R"("tests.method=\"quasistatic\""], are ["stages.0.cells=13"])")
      << "the line may be a comment";
  now.provenance.overrides = study.provenance.overrides;
  EXPECT_EQ(difference(record, now), "deck.toml: line 3 was `times = 1`, is `times = 2`");
  now.provenance.deck_text = "title = \"a\"\n";
  EXPECT_EQ(difference(record, now), "deck.toml: line 2 was `[tests]`, is ``") << "a line that is gone";
  auto older = record;
  older.version = "0.0.1";
  EXPECT_EQ(difference(older, now),
            std::string("they are of version 0.0.1 of Breccia, this is version ") + BRECCIA_VERSION);
}

TEST_F(StudyRecordFile, TellsTheDataFileThatDiffersWhereTheDeckDiffersInACommentAlone) {
  auto& provenance = study.provenance;
  provenance.deck_content_hash = "00000000000000dd";
  provenance.file_hashes = {{"p.csv", "aa"}, {"sizes.csv", "bb"}};
  const auto record = record_of({});
  EXPECT_EQ(record.deck_content_hash, provenance.deck_content_hash);
  EXPECT_EQ(record.file_hashes, provenance.file_hashes);
  auto now = study;
  now.provenance.deck_text = "title = \"a\" # a comment\n[tests]\ntimes = 1\n";
  now.provenance.file_hashes[0].hash = "cc";
  EXPECT_EQ(difference(record, now), "the data file p.csv differs");
  now.provenance.file_hashes[1].hash = "cc";
  EXPECT_EQ(difference(record, now), "the data files p.csv, sizes.csv differ");
  now.provenance.deck_content_hash = "00000000000000ee";
  EXPECT_EQ(difference(record, now), "deck.toml: line 1 was `title = \"a\"`, is `title = \"a\" # a comment`");
}

TEST_F(StudyRecordFile, IsNoneWhereAnotherProgramWroteIt) {
  EXPECT_FALSE(read_study_record(directory.path()).is_ours) << "no file";
  EXPECT_FALSE(read_study_record(directory.path() / "nowhere").is_ours);
  for (const auto* text : {"", "[", "[]", "7", "{}", R"({"program": "other", "hash": "0123456789abcdef"})",
                           R"({"program": 1})", "\xff\xfe"}) {
    EXPECT_FALSE(record_with(text).is_ours) << text;
    EXPECT_FALSE(is_record_of_breccia(directory.path() / "study.json")) << text;
  }
  std::filesystem::remove(directory.path() / "study.json");
  std::filesystem::create_directory(directory.path() / "study.json");
  EXPECT_FALSE(read_study_record(directory.path()).is_ours) << "a directory of that name";
  EXPECT_FALSE(is_record_of_breccia(directory.path() / "study.json"));
}

TEST_F(StudyRecordFile, IsReadAsFarAsItIsSound) {
  const auto record = record_with(R"({"program": "breccia", "version": 1, "hash": ["a"], "complete": "yes",
    "deck_text": null, "overrides": ["a=1", 2], "wall_time_s": "long", "stage_names": "A", "stages": [7, {"tests": []}]})");
  EXPECT_TRUE(record.is_ours);
  EXPECT_TRUE(is_record_of_breccia(directory.path() / "study.json"));
  EXPECT_FALSE(record.is_complete);
  EXPECT_FALSE(record.has_tests);
  EXPECT_EQ(record.version, "");
  EXPECT_EQ(record.hash, "");
  EXPECT_THAT(record.overrides, ElementsAre("a=1"));
  EXPECT_FALSE(record.wall_time);
  EXPECT_THAT(record.stages, IsEmpty());
}

// Clearing a directory of results removes the directories of its stages.
TEST_F(StudyRecordFile, NamesNoDirectoryOutsideOfTheResults) {
  const auto record = record_with(R"({"program": "breccia", "stage_names": ["A", "../B", "/etc", "..", ""],
    "stages": [{"name": "C"}, {"name": "../D"}, {"name": 7}, {"name": "A"}]})");
  EXPECT_THAT(record.stages, ElementsAre("A", "C"));
  EXPECT_THAT(record.stages_packed, ElementsAre("C", "A"));
}

}  // namespace
}  // namespace breccia
