// Tests of `breccia compare`.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coated_discs.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A directory with two runs that differ in the interphase: `out` and `stiff`.
class Compare : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    study = std::make_unique<StudyDirectory>(coated_discs);
    ASSERT_EQ(study->breccia("run").exit_code, 0);
    ASSERT_EQ(run_breccia(study->path(), {"run", "deck.toml", "--out", "stiff", "--threads", "1", "--set",
                                          "materials.interphase.shear=200 MPa"})
                  .exit_code,
              0);
    // Measured values that are those of the first run times 1.1.
    std::string text = "time_s,shear_modulus_Pa\n";
    const auto truth = read_curve(study->result("curves.csv"), "discs", "shear");
    for (std::size_t i = 0; i < truth.size(); i += 5) {
      text += fmt::format("{},{}\n", truth[i].time, 1.1 * truth[i].modulus);
    }
    study->write("g.csv", text + "1000,1e9\n");  // one value is outside of the curves
  }
  static void TearDownTestSuite() { study.reset(); }
  static Outcome compare(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "compare");
    return run_breccia(study->path(), arguments);
  }

  static inline std::unique_ptr<StudyDirectory> study;
};

TEST_F(Compare, ShowsWhatDiffersAndWhatThatDoes) {
  const auto run = compare({"out", "stiff", "--out", "both"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("A = out, discs"), HasSubstr("B = stiff, discs"),
                                HasSubstr("materials.interphase.shear  \"100 MPa\"  \"200 MPa\""), HasSubstr("B/A"),
                                HasSubstr("compare.csv, decks.csv, compare_shear.svg")));
  const auto table =
      read_csv(study->path() / "both" / "compare.csv", {"result", "curve", "unit", "error", "error_of_ratio"});
  const auto soft = read_curve(study->result("curves.csv"), "discs", "shear");
  const auto stiff = read_curve(study->path() / "stiff" / "curves.csv", "discs", "shear");
  ASSERT_EQ(table.rows(), soft.size() + stiff.size());
  for (std::size_t i = 0; i < soft.size(); ++i) {
    EXPECT_NEAR(table.numbers("ratio_to_first")[i], 1.0, 1e-12);
    EXPECT_NEAR(table.numbers("ratio_to_first")[soft.size() + i], stiff[i].modulus / soft[i].modulus, 1e-5);
  }
  EXPECT_THAT(read_text(study->path() / "both" / "decks.csv"), HasSubstr("materials.interphase.shear"));
}

TEST_F(Compare, ShowsMeasuredValuesBesideAll) {
  const auto run = compare({"out", "stiff", "--measured", "g.csv"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output,
              AllOf(HasSubstr("Computed over measured, 13 of 14 values, from 1 ms to 1 s"),
                    HasSubstr("A: 10 % rms, from -9 % at"), HasSubstr("B: "), Not(HasSubstr("Results are in"))));
}

TEST_F(Compare, TheSameStudyIsTheSame) {
  std::filesystem::copy(study->result(""), study->path() / "copy", std::filesystem::copy_options::recursive);
  const auto run = compare({"out", "copy"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("The decks are the same."), HasSubstr(" 1.000\n"), Not(HasSubstr("0.9")),
                                HasSubstr("a ratio without +-: the results do not state all of their errors")));
}

TEST_F(Compare, ComparesOverFrequency) {
  const std::vector<std::string> in_frequency = {
      "--threads", "1", "--set", "tests.times=", "--set", R"(tests.frequencies=["1 Hz", "100 Hz"])", "--out"};
  for (const auto* name : {"soft-hz", "stiff-hz"}) {
    auto arguments = in_frequency;
    arguments.emplace_back(name);
    arguments.insert(arguments.begin(), {"run", "deck.toml"});
    if (name == std::string("stiff-hz"))
      arguments.insert(arguments.end(), {"--set", "materials.interphase.shear=200 MPa"});
    ASSERT_EQ(run_breccia(study->path(), arguments).exit_code, 0);
  }
  study->write("dma.csv", "frequency_Hz,shear_storage_modulus_Pa,shear_loss_modulus_Pa\n10,3e7,4e7\n");
  const auto run = compare({"soft-hz", "stiff-hz", "--measured", "dma.csv", "--out", "hz"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("|G*|"), HasSubstr("phase of G*"), HasSubstr(" deg"), HasSubstr("B - A"),
                                HasSubstr("1 of 1 values, from 1 Hz to 100 Hz")));
  EXPECT_THAT(read_text(study->path() / "hz" / "compare_shear.svg"), HasSubstr("measured"));
  EXPECT_THAT(compare({"out", "soft-hz"}).errors, HasSubstr("in their order: G; |G*|, phase of G*"));
}

TEST_F(Compare, NamesResultsThatAreNotComplete) {
  const auto half = study->path() / "half";
  std::filesystem::copy(study->result(""), half, std::filesystem::copy_options::recursive);
  study->write("half/study.json",
               replaced(read_text(half / "study.json"), "\"complete\": true", "\"complete\": false"));
  const auto run = compare({"out", "half"});
  EXPECT_THAT(run.output + run.errors, HasSubstr("not complete"));
}

TEST_F(Compare, RefusesMistakesAllAtOnce) {
  const auto refusal = [](const std::vector<std::string>& arguments) {
    const auto run = compare(arguments);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.output, "");
    return run.errors;
  };
  EXPECT_THAT(refusal({"out"}), HasSubstr("DIR"));
  EXPECT_THAT(refusal({}), HasSubstr("DIR"));
  EXPECT_THAT(refusal({"out", "./out"}), HasSubstr("./out is given twice"));
  EXPECT_THAT(refusal({"none", "nowhere"}), AllOf(HasSubstr("none"), HasSubstr("nowhere")));
  const auto unread = compare({"out", "stiff", "--measured", "no.csv"});
  EXPECT_EQ(unread.exit_code, 4);
  EXPECT_THAT(unread.errors, HasSubstr("no.csv"));
  EXPECT_THAT(refusal({"out", "deck.toml"}), HasSubstr("deck.toml"));
  EXPECT_THAT(refusal({"out", "stiff", "--stage", "disks"}), HasSubstr("did you mean \"discs\"?"));
  EXPECT_THAT(refusal({"out", "stiff", "--modulus", "G"}), HasSubstr("--modulus"));
  EXPECT_THAT(refusal({"out", "stiff", "--overwrite"}), HasSubstr("--out"));
  study->write("creep.csv", "time_s,compliance_1_per_Pa\n0.01,1e-9\n");
  EXPECT_THAT(refusal({"out", "stiff", "--measured", "creep.csv"}), HasSubstr("creep"));
  EXPECT_THAT(refusal({"out", "stiff", "--out", "out"}), HasSubstr("out: here are the results of a study"));
  EXPECT_TRUE(std::filesystem::exists(study->result("curves.csv")));
}

}  // namespace
}  // namespace breccia::test
