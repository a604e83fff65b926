#include "campaign/result_directory.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "campaign/deck_study.hpp"
#include "messages.hpp"
#include "results/checksums.hpp"
#include "results/result_files.hpp"
#include "results/study_record.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using test::leave;
using testing::AllOf;
using testing::AnyOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ResultDirectory : public testing::Test {
 protected:
  [[nodiscard]] fs::path run_in(const RunOptions& options = {}) const {
    return directory_to_run_in(mine, results, options);
  }
  [[nodiscard]] std::string refusal(const RunOptions& options = {}) const {
    return test::message_of<InputError>([&] { static_cast<void>(run_in(options)); });
  }
  [[nodiscard]] std::string title_in(const fs::path& place) const {
    return read_study_record(place).is_of(mine) ? "mine" : read_study_record(place).is_of(other) ? "other" : "";
  }
  /// Writes a file that Breccia did not write.
  void write_foreign(const fs::path& file) const {
    fs::create_directories(file.parent_path());
    write_text(file, "foreign");
  }

  const Study mine = test::study_of_deck("mine"), other = test::study_of_deck("other");
  test::TemporaryDirectory directory;
  const fs::path results = directory.path() / "results";
  const fs::path unfinished = results / "unfinished";
};

TEST_F(ResultDirectory, IsMade) {
  EXPECT_EQ(run_in(), results);
  EXPECT_TRUE(fs::is_directory(results));
}

TEST_F(ResultDirectory, KeepsEarlierResultsUntilTheNewOnesAreWhole) {
  leave(results, mine, test::complete_result());
  EXPECT_EQ(run_in(), unfinished);
  EXPECT_EQ(title_in(results), "mine");
  EXPECT_TRUE(fs::exists(results / "curves.csv"));
  EXPECT_TRUE(fs::is_empty(unfinished));
}

TEST_F(ResultDirectory, RefusesResultsOfAnotherStudy) {
  leave(results, other, test::complete_result());
  const auto in_words = HasSubstr(
      "here are complete results of another study: deck.toml: line 1 was `title = \"other\"`, "
      "is `title = \"mine\"`; replace them or take another directory");
  EXPECT_THAT(refusal(), in_words);
  EXPECT_THAT(refusal({.replaceable = {"0123456789abcdef"}}), in_words) << "these were not there when the sweep began";
  EXPECT_EQ(run_in({.overwrite = true}), unfinished);
  EXPECT_EQ(run_in({.replaceable = hashes_of_records_in(results)}), unfinished);
  EXPECT_EQ(title_in(results), "other") << "until the new ones are whole";
  leave(results, other, test::tested_result());
  EXPECT_THAT(refusal(), HasSubstr("here are results of another study"));
}

TEST_F(ResultDirectory, RefusesUnfinishedResultsOfAnotherStudy) {
  leave(results, mine, test::complete_result());
  leave(unfinished, other, test::tested_result());
  EXPECT_THAT(refusal(), HasSubstr((unfinished.string() + ": here are results of another study")));
  EXPECT_EQ(run_in({.overwrite = true}), unfinished);
  EXPECT_TRUE(fs::is_empty(unfinished)) << "begun anew";
}

// Packings, unlike tests, may be replaced: they take seconds, and tests take hours.
TEST_F(ResultDirectory, ReplacesPackingsOfAnotherStudy) {
  leave(results, other, test::packed_result());
  EXPECT_EQ(run_in(), unfinished);
  fs::remove_all(results);
  fs::create_directory(results);
  write_provenance(results, other, {});
  EXPECT_EQ(run_in(), results);
  EXPECT_TRUE(fs::is_empty(results)) << "a record alone is no result";
}

TEST_F(ResultDirectory, RefusesToReplaceWhatBrecciaDidNotWrite) {
  write_foreign(results / "notes.txt");
  EXPECT_EQ(run_in(), results) << "nothing is written there";
  write_foreign(results / "curves.csv");
  write_foreign(results / "fine" / "response.h5");
  EXPECT_THAT(refusal({.overwrite = true}),
              AllOf(HasSubstr("results/curves.csv: the results would replace this file, which Breccia did not write"),
                    HasSubstr("\n"), HasSubstr("results/fine/response.h5: the results would replace this file")));
  EXPECT_EQ(read_text(results / "curves.csv"), "foreign");
}

TEST_F(ResultDirectory, RefusesForeignFilesAmongUnfinishedResults) {
  for (const auto* name : {"notes.txt", "fine/notes.txt", "fine/deep/modulus.svg", "study.json"}) {
    write_foreign(unfinished / name);
    EXPECT_THAT(
        refusal({.overwrite = true}),
        HasSubstr((unfinished / name).string() + ": in the way of unfinished results, and not written by Breccia"));
    fs::remove(unfinished / name);
  }
}

TEST_F(ResultDirectory, RefusesThePlaceOfASweep) {
  fs::create_directory(results);
  write_text(results / "sweep.json", R"({"program": "breccia", "tasks": []})");
  for (const bool resume : {false, true}) {
    EXPECT_THAT(refusal({.resume = resume}), HasSubstr("results: here are the results of a sweep; replace them"));
  }
  EXPECT_EQ(run_in({.overwrite = true}), unfinished);
}

TEST_F(ResultDirectory, RefusesToReplaceItsOwnInputs) {
  leave(results, mine, test::complete_result());
  auto study = mine;
  study.provenance.inputs = {results / "curves.csv"};
  EXPECT_THAT(test::message_of<InputError>(
                  [&] { static_cast<void>(directory_to_run_in(study, results, {.overwrite = true})); }),
              HasSubstr("results/curves.csv: the results would replace this file, from which they come"));
}

TEST_F(ResultDirectory, OfAnInterruptedRunIsWhereItGoesOn) {
  leave(results, mine, test::tested_result());
  write_text(results / "fine" / "response.h5.17.partial", "half");
  EXPECT_EQ(run_in({.resume = true}), results);
  EXPECT_TRUE(fs::exists(results / "curves.csv"));
  EXPECT_FALSE(fs::exists(results / "fine" / "response.h5.17.partial"));
  EXPECT_EQ(run_in(), unfinished) << "without --resume it begins anew";
}

TEST_F(ResultDirectory, GoesOnBesideResultsOfAnotherStudy) {
  leave(results, other, test::complete_result());
  leave(unfinished, mine, test::tested_result());
  EXPECT_EQ(run_in({.resume = true}), unfinished);
  EXPECT_TRUE(fs::exists(unfinished / "curves.csv"));
  EXPECT_EQ(title_in(results), "other");
}

TEST_F(ResultDirectory, GoesOnFromNothingWhereThereIsNothing) {
  EXPECT_EQ(run_in({.resume = true}), results);
}

TEST_F(ResultDirectory, DoesNotGoOnFromResultsOfAnotherStudy) {
  leave(results, other, test::tested_result());
  EXPECT_THAT(refusal({.resume = true}), HasSubstr("results: cannot resume from these results: deck.toml: line 1 was"));
  EXPECT_EQ(run_in({.resume = true, .overwrite = true}), unfinished) << "which begins anew";
}

TEST_F(ResultDirectory, OfAPackingKeepsTestsOfTheSameStudy) {
  leave(results, mine, test::tested_result());
  EXPECT_EQ(directory_to_pack_in(mine, results, {}), results);
  EXPECT_TRUE(fs::exists(results / "curves.csv"));
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(directory_to_pack_in(other, results, {})); }),
              HasSubstr("here are results of another study"));
}

TEST_F(ResultDirectory, TakesWholeResultsInThePlaceOfEarlierOnes) {
  leave(results, other, test::complete_result());
  write_text(results / "fine" / "response.h5", "of other");
  write_foreign(results / "notes.txt");
  leave(unfinished, mine, test::complete_result());
  write_text(unfinished / "curves.csv.17.partial", "half");
  put_in_place(mine, unfinished, results);
  EXPECT_EQ(title_in(results), "mine");
  EXPECT_EQ(read_text(results / "fine" / "modulus.svg"), "of mine");
  EXPECT_FALSE(fs::exists(results / "fine" / "response.h5")) << "the new study has none";
  EXPECT_EQ(read_text(results / "notes.txt"), "foreign");
  EXPECT_FALSE(fs::exists(unfinished));
  EXPECT_FALSE(fs::exists(results / "curves.csv.17.partial"));
}

TEST_F(ResultDirectory, TouchesNothingWhereAForeignFileIsInTheWay) {
  leave(results, other, test::complete_result());
  write_foreign(results / "comparison.csv" / "in a directory");
  leave(unfinished, mine, test::complete_result());
  write_text(unfinished / "comparison.csv", "");
  EXPECT_THAT(test::message_of<FileError>([&] { put_in_place(mine, unfinished, results); }),
              AllOf(HasSubstr("results/comparison.csv: not written by Breccia, so it is not replaced"),
                    EndsWith("; the new results are in " + unfinished.string())));
  EXPECT_EQ(title_in(results), "other");
  EXPECT_EQ(title_in(unfinished), "mine");
}

TEST_F(ResultDirectory, BringsAReplacementToItsEnd) {
  leave(results, other, test::complete_result());
  leave(unfinished, mine, test::complete_result());
  finish_interrupted_replacement(mine, results);
  EXPECT_EQ(title_in(results), "mine");
  EXPECT_FALSE(fs::exists(unfinished));
}

TEST_F(ResultDirectory, BringsNoReplacementOfAnotherStudyToItsEnd) {
  leave(results, mine, test::complete_result());
  leave(unfinished, other, test::complete_result());
  finish_interrupted_replacement(mine, results);
  EXPECT_EQ(title_in(results), "mine");
  EXPECT_EQ(title_in(unfinished), "other");
}

TEST_F(ResultDirectory, DropsWhatWasToReplaceCompleteResultsOfTheSameStudy) {
  leave(results, mine, test::complete_result());
  leave(unfinished, mine, test::tested_result());
  finish_interrupted_replacement(mine, results);
  EXPECT_FALSE(fs::exists(unfinished));
  leave(results, other, test::complete_result());
  leave(unfinished, mine, test::tested_result());
  finish_interrupted_replacement(mine, results);
  EXPECT_EQ(title_in(unfinished), "mine") << "there is something to go on from";
}

TEST_F(ResultDirectory, IsObjectedToBeforeAListIsCarriedOut) {
  leave(results, other, test::complete_result());
  leave(unfinished, other, test::complete_result());
  std::string list = "study.json\n";
  for (const auto& name : study_files_in(results, {"fine"})) list += name + "\n";
  write_text(unfinished / "removing.list", list);
  EXPECT_THAT(refusal(), HasSubstr("here are complete results of another study"));
  EXPECT_EQ(title_in(results), "other");
  EXPECT_TRUE(fs::exists(unfinished / "removing.list"));
  EXPECT_EQ(run_in({.overwrite = true}), unfinished);
  EXPECT_FALSE(fs::exists(unfinished / "removing.list"));
}

// A directory from someone else must not make Breccia change files of the user elsewhere.
TEST_F(ResultDirectory, CarriesOutNoListOfOthers) {
  leave(results, mine, test::complete_result());
  leave(unfinished, mine, test::complete_result());
  const auto victim = directory.path() / "victim";
  write_foreign(victim / "precious.txt");
  write_foreign(victim / "modulus.svg");
  write_foreign(results / "notes.txt");
  fs::create_directory_symlink("../victim", results / "link");
  for (const auto* list : {"study.json\nlink/precious.txt\n", "study.json\nlink/modulus.svg\n",
                           "study.json\nnotes.txt\n", "study.json\n../victim/precious.txt\n"}) {
    write_text(unfinished / "removing.list", list);
    for (const bool resume : {false, true}) {
      EXPECT_THAT(refusal({.resume = resume, .overwrite = true}),
                  AnyOf(HasSubstr("removing.list: not as Breccia writes it"), HasSubstr("link: a symbolic link")));
    }
    EXPECT_TRUE(fs::exists(victim / "precious.txt") && fs::exists(victim / "modulus.svg")) << list;
    EXPECT_TRUE(fs::exists(results / "notes.txt")) << list;
    EXPECT_EQ(title_in(results), "mine") << list;
  }
}

TEST_F(ResultDirectory, WritesNothingBeyondALink) {
  const auto victim = directory.path() / "victim";
  write_foreign(victim / "modulus.svg");
  for (const auto& link : {results / "fine", unfinished, unfinished / "fine"}) {
    leave(results, mine, test::complete_result());
    leave(unfinished, mine, test::tested_result());
    fs::remove_all(link);
    fs::create_directory_symlink(victim, link);
    for (const bool resume : {false, true}) {
      EXPECT_THAT(refusal({.resume = resume, .overwrite = true}), HasSubstr(link.string() + ": a symbolic link"));
    }
    EXPECT_EQ(read_text(victim / "modulus.svg"), "foreign");
    fs::remove_all(results);
  }
}

// Without the record the study of the results is not known; their other files are recognised by their checksums.
TEST_F(ResultDirectory, IsRefusedWhereItsRecordIsLost) {
  leave(results, other, test::complete_result());
  write_checksums(results, {"fine"});
  fs::remove(results / "study.json");
  for (const bool resume : {false, true}) {
    EXPECT_THAT(refusal({.resume = resume}),
                HasSubstr("results/study.json: missing, so that nothing tells which study"));
  }
  write_text(results / "study.json", std::string(100, '\0'));
  EXPECT_THAT(refusal({.resume = true}), AllOf(HasSubstr("results/study.json: damaged"), EndsWith("; remove them")));
  fs::remove(results / "study.json");
  write_foreign(results / "prony.csv");
  EXPECT_THAT(refusal({.overwrite = true}), HasSubstr("prony.csv: the results would replace this file"));
  fs::remove(results / "prony.csv");
  EXPECT_EQ(run_in({.overwrite = true}), results);
  EXPECT_FALSE(fs::exists(results / "curves.csv"));
}

TEST_F(ResultDirectory, KnowsItsRecordsByTheirHashes) {
  EXPECT_THAT(hashes_of_records_in(results), IsEmpty());
  write_foreign(results / "study.json");
  EXPECT_THAT(hashes_of_records_in(results), IsEmpty());
  leave(results, other, test::complete_result());
  leave(unfinished, mine, test::tested_result());
  const auto hashes = hashes_of_records_in(results);
  EXPECT_THAT(hashes, SizeIs(2));
  EXPECT_EQ(hashes.at(0), content_hash(read_text(results / "study.json")));
  EXPECT_NE(hashes.at(1), hashes.at(0));
}

}  // namespace
}  // namespace breccia
