// Tests of `breccia assess`.

#include <cmath>
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

/// The coated discs with an interphase and times of the binder that are not certain.
std::string uncertain_discs() {
  const auto with_interphase =
      replaced(std::string(coated_discs), "shear   = \"100 MPa\"", R"(shear   = { value = "100 MPa", factor = 1.5 })");
  const auto with_times = replaced(with_interphase, "[materials.glass]",
                                   "factors = { times = { value = 1, factor = 2 } }\n\n[materials.glass]");
  return replaced(with_times, "[tests.quasistatic]\nvary = { interphase = { shear = [\"10 MPa\", \"1 GPa\"] } }\n",
                  "mixing = \"series\"\n");
}

CsvTable bands_of(const StudyDirectory& study) {
  return read_csv(study.result("assess/bands.csv"),
                  {"curve", "unit", "error_of_model", "whole_lower_95", "whole_upper_95"});
}

CsvTable sensitivity(const StudyDirectory& study) {
  return read_csv(study.result("assess/sensitivity.csv"), {"curve", "input"});
}

TEST(Assess, CarriesTheUncertaintyOfMaterialsThrough) {
  const StudyDirectory study(uncertain_discs());
  const auto run = study.breccia("assess");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("2 uncertain inputs"), HasSubstr("materials.interphase.shear"),
                                HasSubstr("1000 samples\n"), HasSubstr("95 % by the inputs")));
  const auto bands = bands_of(study);
  const auto shares = sensitivity(study);
  ASSERT_GT(bands.rows(), 10U);
  for (std::size_t i = 0; i < bands.rows(); ++i) {
    EXPECT_LT(bands.numbers("inputs_lower_95")[i], bands.numbers("median")[i]);
    EXPECT_GT(bands.numbers("inputs_upper_95")[i], bands.numbers("median")[i]);
    EXPECT_NEAR(bands.numbers("median")[i] / bands.numbers("with_median_inputs")[i], 1.0, 0.06);
    const double alone = shares.numbers("alone")[2 * i] + shares.numbers("alone")[2 * i + 1];
    const double total = shares.numbers("with_others")[2 * i] + shares.numbers("with_others")[2 * i + 1];
    EXPECT_LE(alone, 1.0 + 1e-9);
    EXPECT_NEAR(total - 1.0, 1.0 - alone, 1e-9) << "what two inputs do together counts for both";
    EXPECT_LT(shares.numbers("unexplained")[2 * i], 0.01);
  }
  EXPECT_TRUE(std::filesystem::exists(study.result("assess/bands_G.svg")));
  EXPECT_TRUE(std::filesystem::exists(study.result("assess/sensitivity_G.svg")));
}

TEST(Assess, AgreesWithAnswersOneByOne) {
  // The interphase alone: its interval of 95 % has the answers at the ends of that interval, since G rises with it.
  const StudyDirectory study(uncertain_discs());
  ASSERT_EQ(study.breccia("assess", {"--set", "materials.binder.factors=", "--samples", "400"}).exit_code, 0);
  const auto bands = bands_of(study);
  for (const auto& [column, score] : {std::pair("inputs_lower_95", -1.96), std::pair("inputs_upper_95", 1.96)}) {
    study.write("end.toml", fmt::format("density = \"1.2 g/cm^3\"\nbulk = \"2 GPa\"\nshear = \"{} MPa\"\n",
                                        100.0 * std::pow(1.5, score)));
    ASSERT_EQ(run_breccia(study.path(),
                          {"respond", "out", "--material", "interphase=end.toml", "--out", "end", "--overwrite"})
                  .exit_code,
              0);
    const auto end = read_curve(study.path() / "end" / "curves.csv", "discs", "shear");
    ASSERT_EQ(end.size(), bands.rows());
    for (std::size_t i = 0; i < end.size(); ++i) EXPECT_NEAR(bands.numbers(column)[i] / end[i].modulus, 1.0, 0.01);
  }
}

TEST(Assess, GivesTheSameBitsForAnyNumberOfThreadsAndTakesResultsThatAreThere) {
  const StudyDirectory study(uncertain_discs());
  ASSERT_EQ(study.breccia("assess", {"--samples", "200"}).exit_code, 0);
  const auto bands = read_text(study.result("assess/bands.csv"));
  const auto again =
      run_breccia(study.path(), {"assess", "deck.toml", "--out", "out", "--samples", "200", "--threads", "3"});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_THAT(again.output, Not(HasSubstr("snapshots"))) << "nothing is solved again";
  EXPECT_EQ(read_text(study.result("assess/bands.csv")), bands);
}

TEST(Assess, SolvesBoxesForAGeometry) {
  const auto deck = replaced(uncertain_discs(), R"("0.4 mm")", R"({ value = "0.4 mm", sd = "0.05 mm" })");
  const StudyDirectory study(deck);
  const auto run = study.breccia("assess", {"--boxes", "5", "--samples", "300"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("(a box for each value)"), HasSubstr("300 samples in 5 boxes")));
  EXPECT_TRUE(std::filesystem::exists(study.result("median/study.json")));
  EXPECT_TRUE(std::filesystem::exists(study.result("box-05/study.json")));
  // A box that was lost is solved again, the others are not.
  std::filesystem::remove_all(study.result("box-03"));
  const auto again = study.breccia("assess", {"--boxes", "5", "--samples", "300"});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_THAT(again.output, AllOf(HasSubstr("box-02, complete already"), HasSubstr("box-03\n")));
}

TEST(Assess, AnswersOverFrequency) {
  const auto deck =
      replaced(uncertain_discs(), R"(times      = ["1 ms", "1 s"])", R"(frequencies = ["1 Hz", "100 Hz"])");
  const StudyDirectory study(deck);
  const auto run = study.breccia("assess", {"--samples", "200"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("|G*|"), HasSubstr("phase of G*"), HasSubstr("10 Hz"), HasSubstr(" deg")));
  EXPECT_TRUE(std::filesystem::exists(study.result("assess/bands_phase-of-G.svg")));
}

TEST(Assess, FindsTheInputsFromMeasurements) {
  const StudyDirectory study(uncertain_discs());
  // The truth: an interphase of 130 MPa, and times of 1.5 times those of the deck.
  ASSERT_EQ(study
                .breccia("run",
                         {"--set", "materials.interphase.shear=130 MPa", "--set", "materials.binder.factors.times=1.5"})
                .exit_code,
            0);
  std::string text = "time_s,shear_modulus_Pa\n";
  const auto truth = read_curve(study.result("curves.csv"), "discs", "shear");
  for (std::size_t i = 0; i < truth.size(); i += 5) text += fmt::format("{},{}\n", truth[i].time, truth[i].modulus);
  study.write("g.csv", text);
  const auto run =
      study.breccia("assess", {"--overwrite", "--measured", "g.csv", "--noise", "1 %", "--model-error", "1 %"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("13 measured values of discs"), HasSubstr("materials.interphase.shear")));
  const auto found = read_csv(study.result("assess/measured/estimates.csv"), {"unknown", "unit"});
  ASSERT_EQ(found.rows(), 3U) << "two inputs, and the factor of the model";
  EXPECT_NEAR(found.numbers("value")[0], 1.5, 0.15);
  EXPECT_NEAR(found.numbers("value")[1] / 130e6, 1.0, 0.1);
  for (const auto& [row, value] : {std::pair(0U, 1.5), std::pair(1U, 130e6)}) {
    EXPECT_LT(found.numbers("lower_95")[row], value);
    EXPECT_GT(found.numbers("upper_95")[row], value);
  }
  EXPECT_THAT(study.breccia("assess", {"--measured", "none.csv"}).errors, HasSubstr("none.csv"));
  EXPECT_THAT(study.breccia("assess", {"--measured", "g.csv", "--noise", "1"}).errors, HasSubstr("--noise: expected"));
}

TEST(Assess, ARunTakesMediansAndSaysSo) {
  const StudyDirectory study(uncertain_discs());
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(
      run.output + run.errors,
      HasSubstr("not certain: materials.binder.factors.times, materials.interphase.shear; these results are those "
                "with their medians"));
}

TEST(Assess, RefusesMistakes) {
  const StudyDirectory study(uncertain_discs());
  const auto refusal = [&](const std::vector<std::string>& more) {
    const auto run = study.breccia("assess", more);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(study.result("assess")));
    return run.errors;
  };
  const std::string certain = "materials.interphase.shear=100 MPa";
  EXPECT_THAT(refusal({"--set", certain, "--set", "materials.binder.factors="}),
              HasSubstr("every input is certain; expected a distribution"));
  EXPECT_THAT(refusal({"--set", "tests.method=dynamic"}), HasSubstr("an assessment takes the reduced responses"));
  EXPECT_THAT(refusal({"--set", R"(materials.interphase.shear={ value = "100 MPa", sd = "90 MPa" })"}),
              HasSubstr("materials.interphase.shear.sd: expected less than a quarter"));
  EXPECT_THAT(refusal({"--set", R"(materials.interphase.shear={ from = "2 MPa", to = "1 MPa" })"}),
              HasSubstr("expected two rising values"));
  EXPECT_THAT(refusal({"--set", R"(materials.interphase.shear={ median = "2 MPa", factor = 2 })"}),
              HasSubstr("materials.interphase.shear.value: missing"));
  EXPECT_THAT(refusal({"--set", "stages.discs.cells={ any = [] }"}),
              HasSubstr("stages.discs.cells.any: expected an array"));
  EXPECT_THAT(refusal({"--set", "stages.discs.cells={ any = [16, 0] }"}), HasSubstr("stages.discs.cells: expected"));
  EXPECT_THAT(refusal({"--samples", "10"}), HasSubstr("--samples"));
  EXPECT_THAT(refusal({"--boxes", "1"}), HasSubstr("--boxes"));
  EXPECT_THAT(refusal({"--noise", "2 %"}), HasSubstr("--measured"));
  EXPECT_THAT(study.breccia("assess", {"--stage", "disks"}).errors,
              HasSubstr(R"(no stage "disks", did you mean "discs"?)"));
}

}  // namespace
}  // namespace breccia::test
