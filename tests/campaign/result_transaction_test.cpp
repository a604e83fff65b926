#include "campaign/result_transaction.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ResultTransactionTest : public testing::Test {
 protected:
  /// The place of a run that ends as soon as it has begun; `begun` has the files there, relative to it.
  [[nodiscard]] fs::path run_in(const RunOptions& options = {}) { return run_in(mine, options); }
  [[nodiscard]] fs::path run_in(const Study& study, const RunOptions& options) {
    ResultTransaction run(study, results, options);
    run.begin_run();
    look_into(run.place());
    return run.place();
  }
  [[nodiscard]] fs::path pack_in(const Study& study, const RunOptions& options = {}) {
    ResultTransaction packing(study, results, options);
    packing.begin_packing();
    look_into(packing.place());
    return packing.place();
  }
  /// Of the earlier records.
  [[nodiscard]] std::vector<std::string> hashes() const {
    EarlierResults earlier(mine, results);
    earlier.read();
    return earlier.hashes;
  }
  void look_into(const fs::path& place) {
    begun.clear();
    for (const auto& entry : fs::recursive_directory_iterator(place)) {
      if (entry.is_regular_file()) begun.push_back(entry.path().lexically_relative(place).string());
    }
  }
  [[nodiscard]] std::optional<double> taken_over() const {
    return ResultTransaction(mine, results, {}).take_over().seconds;
  }
  [[nodiscard]] std::string refusal(const RunOptions& options = {}) {
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
  std::vector<std::string> begun;
};

TEST_F(ResultTransactionTest, MakesItsDirectory) {
  EXPECT_EQ(run_in(), results);
  EXPECT_THAT(begun, ElementsAre("study.json")) << "who comes later is told what differs";
  EXPECT_FALSE(fs::exists(results)) << "a record alone is no result";
}

TEST_F(ResultTransactionTest, HasItsDirectoryForItself) {
  {
    ResultTransaction run(mine, results, {});
    EXPECT_FALSE(fs::exists(results)) << "nothing is there to be read";
    run.begin_run();
    EXPECT_THROW(DirectoryLock another(results), DirectoryInUse);
    EXPECT_THROW(ResultTransaction another(mine, results, {}), DirectoryInUse);
    leave(results, mine, test::packed_result());
  }
  EXPECT_NO_THROW(DirectoryLock another(results));
  EXPECT_TRUE(fs::exists(results / "study.json")) << "a packing is a result";
}

TEST_F(ResultTransactionTest, LeavesNoEmptyDirectoryOfAStage) {
  {
    ResultTransaction run(mine, results, {});
    run.begin_run();
    leave(results, mine, test::packed_result());
    fs::remove(results / "fine" / "modulus.svg");
  }
  EXPECT_FALSE(fs::exists(results / "fine"));
}

TEST_F(ResultTransactionTest, KeepsARecordOfAPackingThatMayHaveBeenMovedElsewhere) {
  leave(results, mine, test::packed_result());
  fs::remove_all(results / "fine");
  fs::remove(results / "curves.csv");
  EXPECT_EQ(run_in({.resume = true}), results);
  EXPECT_TRUE(fs::exists(results / "study.json"));
}

TEST_F(ResultTransactionTest, KeepsEarlierResultsUntilTheNewOnesAreWhole) {
  leave(results, mine, test::complete_result());
  EXPECT_EQ(run_in(), unfinished);
  EXPECT_EQ(title_in(results), "mine");
  EXPECT_TRUE(fs::exists(results / "curves.csv"));
  EXPECT_THAT(begun, ElementsAre("study.json"));
  EXPECT_FALSE(fs::exists(unfinished)) << "without a result";
}

TEST_F(ResultTransactionTest, RefusesResultsOfAnotherStudy) {
  leave(results, other, test::complete_result());
  const auto in_words = HasSubstr(
      "here are complete results of another study: deck.toml: line 1 was `title = \"other\"`, "
      "is `title = \"mine\"`; replace them or take another directory");
  EXPECT_THAT(refusal(), in_words);
  EXPECT_THAT(refusal({.replaceable = {"0123456789abcdef"}}), in_words) << "these were not there when the sweep began";
  EXPECT_EQ(run_in({.overwrite = true}), unfinished);
  EXPECT_EQ(run_in({.replaceable = hashes()}), unfinished);
  EXPECT_EQ(title_in(results), "other") << "until the new ones are whole";
  leave(results, other, test::tested_result());
  EXPECT_THAT(refusal(), HasSubstr("here are results of another study"));
}

TEST_F(ResultTransactionTest, RefusesUnfinishedResultsOfAnotherStudy) {
  leave(results, mine, test::complete_result());
  leave(unfinished, other, test::tested_result());
  EXPECT_THAT(refusal(), HasSubstr((unfinished.string() + ": here are results of another study")));
  EXPECT_EQ(run_in({.overwrite = true}), unfinished);
  EXPECT_THAT(begun, ElementsAre("study.json")) << "begun anew";
}

// Packings, unlike tests, may be replaced: they take seconds, and tests take hours.
TEST_F(ResultTransactionTest, ReplacesPackingsOfAnotherStudy) {
  leave(results, other, test::packed_result());
  EXPECT_EQ(run_in(), unfinished);
  fs::remove_all(results);
  fs::create_directory(results);
  write_provenance(results, other, {});
  EXPECT_EQ(run_in(), results);
  EXPECT_THAT(begun, ElementsAre("study.json")) << "a record alone is no result";
}

TEST_F(ResultTransactionTest, RefusesToReplaceWhatBrecciaDidNotWrite) {
  write_foreign(results / "notes.txt");
  EXPECT_EQ(run_in(), results) << "nothing is written there";
  fs::remove(results / "study.json");
  write_foreign(results / "curves.csv");
  write_foreign(results / "fine" / "response.h5");
  EXPECT_THAT(refusal({.overwrite = true}),
              AllOf(HasSubstr("results/curves.csv: the results would replace this file, which Breccia did not write"),
                    HasSubstr("\n"), HasSubstr("results/fine/response.h5: the results would replace this file")));
  EXPECT_EQ(read_text(results / "curves.csv"), "foreign");
}

TEST_F(ResultTransactionTest, RefusesForeignFilesAmongUnfinishedResults) {
  for (const auto* name : {"notes.txt", "fine/notes.txt", "fine/deep/modulus.svg", "study.json"}) {
    write_foreign(unfinished / name);
    EXPECT_THAT(
        refusal({.overwrite = true}),
        HasSubstr((unfinished / name).string() + ": in the way of unfinished results, and not written by Breccia"));
    fs::remove(unfinished / name);
  }
}

TEST_F(ResultTransactionTest, RefusesThePlaceOfASweep) {
  fs::create_directory(results);
  write_text(results / "sweep.json", R"({"program": "breccia", "tasks": []})");
  for (const bool resume : {false, true}) {
    EXPECT_THAT(refusal({.resume = resume}), HasSubstr("results: here are the results of a sweep; replace them"));
  }
  EXPECT_EQ(run_in({.overwrite = true}), unfinished);
}

TEST_F(ResultTransactionTest, RefusesToReplaceItsOwnInputs) {
  leave(results, mine, test::complete_result());
  auto study = mine;
  study.provenance.inputs = {results / "curves.csv"};
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(run_in(study, {.overwrite = true})); }),
              HasSubstr("results/curves.csv: the results would replace this file, from which they come"));
}

TEST_F(ResultTransactionTest, OfAnInterruptedRunIsWhereItGoesOn) {
  leave(results, mine, test::tested_result());
  write_text(results / "fine" / "response.h5.17.partial", "half");
  EXPECT_EQ(run_in({.resume = true}), results);
  EXPECT_TRUE(fs::exists(results / "curves.csv"));
  EXPECT_FALSE(fs::exists(results / "fine" / "response.h5.17.partial"));
  EXPECT_EQ(run_in(), unfinished) << "without --resume it begins anew";
}

TEST_F(ResultTransactionTest, GoesOnBesideResultsOfAnotherStudy) {
  leave(results, other, test::complete_result());
  leave(unfinished, mine, test::tested_result());
  EXPECT_EQ(run_in({.resume = true}), unfinished);
  EXPECT_TRUE(fs::exists(unfinished / "curves.csv"));
  EXPECT_EQ(title_in(results), "other");
}

TEST_F(ResultTransactionTest, GoesOnFromNothingWhereThereIsNothing) {
  EXPECT_EQ(run_in({.resume = true}), results);
}

TEST_F(ResultTransactionTest, DoesNotGoOnFromResultsOfAnotherStudy) {
  leave(results, other, test::tested_result());
  EXPECT_THAT(refusal({.resume = true}), HasSubstr("results: cannot resume from these results: deck.toml: line 1 was"));
  EXPECT_EQ(run_in({.resume = true, .overwrite = true}), unfinished) << "which begins anew";
}

TEST_F(ResultTransactionTest, OfAPackingKeepsTestsOfTheSameStudy) {
  leave(results, mine, test::tested_result());
  EXPECT_EQ(pack_in(mine), results);
  EXPECT_TRUE(fs::exists(results / "curves.csv"));
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(pack_in(other)); }),
              HasSubstr("here are results of another study"));
}

// As `pack --resume` of a sweep may, whose earlier run was to replace them.
TEST_F(ResultTransactionTest, OfAPackingDoesNotGoOnFromAnotherStudyThatItMayReplace) {
  leave(results, other, test::complete_result());
  EXPECT_EQ(pack_in(mine, {.resume = true, .replaceable = hashes()}), unfinished);
  EXPECT_EQ(title_in(results), "other");
}

TEST_F(ResultTransactionTest, PutsWholeResultsInThePlaceOfEarlierOnes) {
  leave(results, other, test::complete_result());
  write_text(results / "fine" / "response.h5", "of other");
  write_foreign(results / "notes.txt");
  ResultTransaction run(mine, results, {.overwrite = true});
  run.begin_run();
  leave(run.place(), mine, test::complete_result());
  write_text(unfinished / "curves.csv.17.partial", "half");
  EXPECT_EQ(title_in(results), "other");
  run.commit();
  EXPECT_EQ(title_in(results), "mine");
  EXPECT_EQ(read_text(results / "fine" / "modulus.svg"), "of mine");
  EXPECT_FALSE(fs::exists(results / "fine" / "response.h5")) << "the new study has none";
  EXPECT_EQ(read_text(results / "notes.txt"), "foreign");
  EXPECT_FALSE(fs::exists(unfinished));
  EXPECT_FALSE(fs::exists(results / "curves.csv.17.partial"));
}

TEST_F(ResultTransactionTest, TouchesNothingWhereAForeignFileIsInTheWay) {
  leave(results, other, test::complete_result());
  ResultTransaction run(mine, results, {.overwrite = true});
  run.begin_run();
  leave(unfinished, mine, test::complete_result());
  write_text(unfinished / "comparison.csv", "");
  write_foreign(results / "comparison.csv" / "in a directory");
  EXPECT_THAT(test::message_of<FileError>([&] { run.commit(); }),
              AllOf(HasSubstr("results/comparison.csv: not written by Breccia, so it is not replaced"),
                    EndsWith("; the new results are in " + unfinished.string())));
  EXPECT_EQ(title_in(results), "other");
  EXPECT_EQ(title_in(unfinished), "mine");
}

TEST_F(ResultTransactionTest, KeepsAFileThatItsUserPutInTheWayMeanwhile) {
  leave(results, other, test::complete_result());
  ResultTransaction run(mine, results, {.overwrite = true});
  run.begin_run();
  leave(unfinished, mine, test::complete_result());
  write_text(unfinished / "comparison.csv", "");
  write_foreign(results / "comparison.csv");
  EXPECT_THROW(run.commit(), FileError);
  EXPECT_EQ(read_text(results / "comparison.csv"), "foreign");
}

TEST_F(ResultTransactionTest, BringsAReplacementToItsEnd) {
  leave(results, other, test::complete_result());
  leave(unfinished, mine, test::complete_result());
  EXPECT_TRUE(taken_over());
  EXPECT_EQ(title_in(results), "mine");
  EXPECT_FALSE(fs::exists(unfinished));
}

TEST_F(ResultTransactionTest, BringsNoReplacementOfAnotherStudyToItsEnd) {
  leave(results, mine, test::complete_result());
  leave(unfinished, other, test::complete_result());
  EXPECT_TRUE(taken_over());
  EXPECT_EQ(title_in(results), "mine");
  EXPECT_EQ(title_in(unfinished), "other");
}

TEST_F(ResultTransactionTest, DropsWhatWasToReplaceCompleteResultsOfTheSameStudy) {
  leave(results, mine, test::complete_result());
  leave(unfinished, mine, test::tested_result());
  EXPECT_TRUE(taken_over());
  EXPECT_FALSE(fs::exists(unfinished));
  leave(results, other, test::complete_result());
  leave(unfinished, mine, test::tested_result());
  EXPECT_FALSE(taken_over());
  EXPECT_EQ(title_in(unfinished), "mine") << "there is something to go on from";
}

TEST_F(ResultTransactionTest, IsObjectedToBeforeAListIsCarriedOut) {
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
TEST_F(ResultTransactionTest, CarriesOutNoListOfOthers) {
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

TEST_F(ResultTransactionTest, WritesNothingBeyondALink) {
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
TEST_F(ResultTransactionTest, IsRefusedWhereItsRecordIsLost) {
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

TEST_F(ResultTransactionTest, KnowsEarlierRecordsByTheirHashes) {
  EXPECT_THAT(hashes(), IsEmpty());
  write_foreign(results / "study.json");
  EXPECT_THAT(hashes(), IsEmpty());
  leave(results, other, test::complete_result());
  leave(unfinished, mine, test::tested_result());
  ASSERT_THAT(hashes(), SizeIs(2));
  EXPECT_EQ(hashes().at(0), content_hash(read_text(results / "study.json")));
  EXPECT_NE(hashes().at(1), hashes().at(0));
}

// What a newer version may have written in another way is not taken for packings, which are replaced unasked.
TEST_F(ResultTransactionTest, RefusesResultsOfAnotherVersionInAnotherFormat) {
  fs::create_directories(results);
  for (const auto* rest : {R"("version": "0.0.1", "complete": true, "stages": [{"name": "fine", "tests": []}])",
                           R"("version": "9.0.0", "stages": {"fine": {"loads": []}})", R"("version": "9.0.0")",
                           R"("version": "9.0.0", "stages": [{"name": "fine", "curves": 3}])", R"("format": 9)"}) {
    write_text(results / "study.json", std::string(R"({"program": "breccia", )") + rest + "}");
    EXPECT_THAT(refusal(), AllOf(HasSubstr("here are "), HasSubstr("they are of "), HasSubstr("version"),
                                 HasSubstr("; replace them or take another directory")))
        << rest;
    EXPECT_THAT(refusal({.resume = true}), HasSubstr("cannot resume from these results: they are of ")) << rest;
    EXPECT_EQ(run_in({.overwrite = true}), unfinished) << "until the new ones are complete";
    EXPECT_TRUE(fs::exists(results / "study.json")) << rest;
  }
}

}  // namespace
}  // namespace breccia
