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
    study->write("g.csv", text);
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
  EXPECT_THAT(run.output, AllOf(HasSubstr("Computed over measured"), HasSubstr("A: 13 values, 10 % rms, from -9 % at"),
                                HasSubstr("B: 13 values"), Not(HasSubstr("Results are in"))));
}

TEST_F(Compare, TheSameResultsAreTheSame) {
  const auto run = compare({"out", "out"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("The decks are the same."), HasSubstr("1.000")));
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
  EXPECT_THAT(refusal({"none", "nowhere"}), AllOf(HasSubstr("none"), HasSubstr("nowhere")));
  EXPECT_THAT(compare({"out", "stiff", "--measured", "no.csv"}).errors, HasSubstr("no.csv"));
  EXPECT_THAT(refusal({"out", "deck.toml"}), HasSubstr("deck.toml"));
  EXPECT_THAT(refusal({"out", "stiff", "--stage", "disks"}), HasSubstr("did you mean \"discs\"?"));
  EXPECT_THAT(refusal({"out", "stiff", "--modulus", "G"}), HasSubstr("--modulus"));
  EXPECT_THAT(refusal({"out", "stiff", "--overwrite"}), HasSubstr("--out"));
  study->write("creep.csv", "time_s,compliance_1_per_Pa\n0.01,1e-9\n");
  EXPECT_THAT(refusal({"out", "stiff", "--measured", "creep.csv"}), HasSubstr("creep"));
  study->write("late.csv", "time_s,shear_modulus_Pa\n1000,1e9\n");
  EXPECT_THAT(refusal({"out", "stiff", "--measured", "late.csv"}), HasSubstr("no measured value is within the curves"));
  EXPECT_THAT(refusal({"out", "stiff", "--out", "out"}), HasSubstr("out"));
  EXPECT_TRUE(std::filesystem::exists(study->result("curves.csv")));
}

}  // namespace
}  // namespace breccia::test
