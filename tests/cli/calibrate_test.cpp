// Tests of `breccia calibrate`. The measurements are answers of `breccia respond`, which takes another way from the
// moduli to the curves: the modes of the reduced stiffness, not complex Laplace variables.

#include <algorithm>
#include <cmath>
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

/// The coated discs with a shift law of their binder, from 10 us.
std::string discs_with_a_law() {
  const std::string law =
      R"(temperature_shift = { law = "wlf", c1 = 8, c2 = "100 K", reference = "20 degC", temperature = "20 degC" })";
  const auto with_law =
      replaced(std::string(coated_discs), "[materials.glass]", fmt::format("{}\n\n[materials.glass]", law));
  return replaced(with_law, R"(["1 ms", "1 s"])", R"(["10 us", "1 s"])");
}

constexpr std::string_view soft_interphase = "density = \"1.2 g/cm^3\"\nbulk = \"2 GPa\"\nshear = \"40 MPa\"\n";

/// The binder with times that are three times as long.
constexpr std::string_view slow_binder = R"(density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "1 MPa", terms = [
  { time = "300 us", modulus = "500 MPa" }, { time = "3 ms", modulus = "300 MPa" }, { time = "30 ms", modulus = "90 MPa" }] }
)";

class Calibrate : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    study = std::make_unique<StudyDirectory>(discs_with_a_law());
    ASSERT_EQ(study->breccia("run").exit_code, 0);
    study->write("soft.toml", soft_interphase);
    study->write("slow.toml", slow_binder);
    ASSERT_EQ(breccia({"respond", "out", "--material", "interphase=soft.toml", "--material", "matrix=slow.toml",
                       "--out", "truth"})
                  .exit_code,
              0);
    const auto curve = read_curve(study->path() / "truth" / "curves.csv", "discs", "shear");
    std::string text = "time_s,shear_modulus_Pa\n";
    for (std::size_t i = 0; i < curve.size(); i += 5) {
      text += fmt::format("{},{}\n", curve[i].time, curve[i].modulus);
    }
    study->write("g.csv", text);
  }
  static void TearDownTestSuite() { study.reset(); }

  static Outcome breccia(const std::vector<std::string>& arguments) { return run_breccia(study->path(), arguments); }
  static Outcome calibrate(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"calibrate", "out"};
    std::ranges::copy(more, std::back_inserter(arguments));
    return breccia(arguments);
  }
  static CsvTable estimates(const std::string& directory) {
    return read_csv(study->path() / directory / "estimates.csv", {"unknown", "unit"});
  }

  static std::unique_ptr<StudyDirectory> study;
};

std::unique_ptr<StudyDirectory> Calibrate::study;

TEST_F(Calibrate, FindsAnInterphaseAndTheTimesOfABinder) {
  const auto run = calibrate(
      {"--measured", "g.csv", "--unknown", "interphase.shear", "--unknown", "binder.times", "--out", "found"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto found = estimates("found");
  ASSERT_EQ(found.rows(), 2U);
  EXPECT_EQ(found.text("unknown")[0], "interphase.shear");
  EXPECT_NEAR(found.numbers("value")[0] / 40e6, 1.0, 1e-3);
  EXPECT_NEAR(found.numbers("value")[1] / 3.0, 1.0, 1e-3);
  EXPECT_THAT(run.output, AllOf(HasSubstr("interphase.shear"), HasSubstr("40 MPa"), HasSubstr("within a factor 10")));
  EXPECT_THAT(run.output, HasSubstr("the error of its model is not known and not in the intervals"));
}

TEST_F(Calibrate, WritesMaterialsThatRespondTakes) {
  ASSERT_EQ(calibrate({"--measured", "g.csv", "--unknown", "interphase.shear", "--unknown", "binder.times", "--out",
                       "materials", "--quiet"})
                .exit_code,
            0);
  const auto answer = breccia({"respond", "out", "--material", "interphase=materials/interphase.toml", "--material",
                               "binder=materials/binder.toml", "--out", "again"});
  ASSERT_EQ(answer.exit_code, 0) << answer.errors;
  const auto again = read_curve(study->path() / "again" / "curves.csv", "discs", "shear");
  const auto truth = read_curve(study->path() / "truth" / "curves.csv", "discs", "shear");
  for (std::size_t i = 0; i < truth.size(); i += 10) {
    EXPECT_NEAR(again[i].modulus / truth[i].modulus, 1.0, 1e-3) << truth[i].time;
  }
  // At another temperature, too: its law has come along.
  EXPECT_EQ(breccia({"respond", "out", "--material", "binder=materials/binder.toml", "--out", "law"}).exit_code, 0);
  EXPECT_THAT(read_text(study->path() / "materials" / "binder.toml"), HasSubstr("c1 = 8"));
}

TEST_F(Calibrate, FindsASpectrumWithoutItsTimes) {
  const auto run =
      calibrate({"--measured", "g.csv", "--unknown", R"(binder.spectrum={ from = "10 us", to = "1 s" })", "--unknown",
                 R"(interphase.shear={ value = "40 MPa", sd = "1 MPa" })", "--out", "spectrum"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto found = estimates("spectrum");
  EXPECT_EQ(found.rows(), 12U) << "two terms a decade, and the interphase";
  const auto predictions = read_csv(study->path() / "spectrum" / "predictions.csv",
                                    {"composite", "modulus", "curve", "unit_of_at", "temperature_K"});
  for (std::size_t i = 0; i < predictions.rows(); ++i) {
    EXPECT_NEAR(predictions.numbers("predicted")[i] / predictions.numbers("measured")[i], 1.0, 0.03) << i;
  }
}

// Dynamic moduli at two temperatures tell a constant of the shift law; the other stays as it was assumed.
TEST_F(Calibrate, FindsAConstantOfTheShiftLaw) {
  std::string text = "angular_frequency_rad_per_s,temperature_degC,shear_storage_modulus_Pa,shear_loss_modulus_Pa\n";
  for (const auto& [temperature, name] : {std::pair{20, "20 degC"}, {40, "40 degC"}}) {
    ASSERT_EQ(breccia({"respond", "out", "--temperature", name, "--frequencies", "1 Hz", "1 kHz", "--out",
                       fmt::format("at-{}", temperature)})
                  .exit_code,
              0);
    const auto moduli = read_csv(study->path() / fmt::format("at-{}", temperature) / "dynamic.csv",
                                 {"stage", "load", "boundary", "method", "cells", "error"});
    for (std::size_t i = 0; i < moduli.rows(); i += 4) {
      text += fmt::format("{},{},{},{}\n", moduli.numbers("angular_frequency_rad_per_s")[i], temperature,
                          moduli.numbers("storage_modulus_Pa")[i], moduli.numbers("loss_modulus_Pa")[i]);
    }
  }
  study->write("dma.csv", text);
  const auto run = calibrate({"--measured", "dma.csv", "--unknown", "binder.c1={ value = 9, factor = 1.3 }",
                              "--unknown", "interphase.shear", "--out", "law-found"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto found = estimates("law-found");
  EXPECT_NEAR(found.numbers("value")[0], 8.0, 0.01);
  EXPECT_NEAR(found.numbers("value")[1] / 100e6, 1.0, 0.01);
}

TEST_F(Calibrate, SaysWhichUnknownsTheDataDoNotTell) {
  const auto run = calibrate({"--measured", "g.csv", "--unknown", "interphase.shear", "--unknown", "binder.times",
                              "--unknown", "binder.c1", "--out", "untold"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("the data say nothing of binder.c1: only what was assumed is known"));
}

TEST_F(Calibrate, SaysThatNothingExplainsTheData) {
  std::string text = "time_s,shear_modulus_Pa\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("{},{}\n", 1e-4 * std::pow(1.3, i), i < 10 ? 4e9 : 1e6);
  study->write("step.csv", text);
  const auto run =
      calibrate({"--measured", "step.csv", "--unknown", "binder.times", "--noise", "5 %", "--out", "step"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("no values of these unknowns explain the data within their noise"));
}

// The data are those of a binder with longer times, which are not among the unknowns.
TEST_F(Calibrate, SaysThatTheModelDoesNotFollowTheData) {
  const auto run = calibrate({"--measured", "g.csv", "--unknown", "interphase.shear", "--out", "wrong"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("the deviations are no scatter: neighbouring ones are alike"));
}

TEST_F(Calibrate, TakesAnErrorOfTheModel) {
  const auto run = calibrate({"--measured", "g.csv", "--unknown", "interphase.shear", "--unknown", "binder.times",
                              "--noise", "1 %", "--model-error", "10 %", "--out", "uncertain"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("model of out"));
  EXPECT_THAT(run.output, Not(HasSubstr("is not known and not in the intervals")));
}

TEST_F(Calibrate, RefusesAllMistakesAtOnce) {
  const auto run = calibrate({"--measured", "g.csv",
                              "--unknown",  "interfase.shear",
                              "--unknown",  "binder",
                              "--unknown",  "binder.tims",
                              "--unknown",  "binder.times={ value = 1 }",
                              "--unknown",  "binder.times=3",
                              "--unknown",  "binder.modulus={ value = 1, sd = 0.5 }",
                              "--unknown",  R"(interphase.shear={ value = "40 mm", sd = "1 MPa" })",
                              "--unknown",  "binder.times={ from = 3, to = 1 }",
                              "--unknown",  R"(binder.c2={ value = "100 K", factor = 1 })"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors,
              AllOf(HasSubstr(R"(unknown: no material "interfase", did you mean "interphase"?)"),
                    HasSubstr(R"(unknown: expected MATERIAL.NUMBER, such as binder.times, got "binder")"),
                    HasSubstr(R"(unknown: binder has no "tims" that could be unknown, did you mean "times"?)"),
                    HasSubstr("binder.times: prior: expected exactly one of sd, factor, to"),
                    HasSubstr("binder.times: prior: expected what is known, as in { value ="),
                    HasSubstr("binder.modulus: prior.sd: expected less than a quarter of the distance"),
                    HasSubstr(R"(interphase.shear: prior.value: expected a pressure, got "40 mm")"),
                    HasSubstr("binder.times: prior.to: expected two rising values, got 3 and 1"),
                    HasSubstr("binder.c2: prior.factor: expected a factor above 1, got 1")));
}

TEST_F(Calibrate, RefusesWhatHasNoMeaning) {
  const auto message = [](const std::vector<std::string>& more) {
    const auto run = calibrate(more);
    EXPECT_EQ(run.exit_code, 2) << run.output;
    return run.errors;
  };
  EXPECT_THAT(message({"--measured", "g.csv", "--unknown", "glass.shear"}),
              AllOf(HasSubstr("glass does not vary"), HasSubstr("tests.quasistatic.vary")));
  EXPECT_THAT(message({"--measured", "g.csv", "--unknown", "binder.young"}),
              HasSubstr("binder.young: the material relaxes"));
  EXPECT_THAT(message({"--measured", "g.csv", "--unknown", "interphase.times"}),
              HasSubstr("interphase.times: the material does not relax"));
  EXPECT_THAT(message({"--measured", "g.csv", "--unknown", "binder.times", "--noise", "2"}),
              HasSubstr("--noise: expected a percentage between 0 and 100"));
  EXPECT_THAT(message({"--measured", "nothing=g.csv", "--unknown", "binder.times"}),
              HasSubstr(R"(--measured: no results are called "nothing"; there are out)"));
  study->write("bulk.csv", "time_s,bulk_modulus_GPa\n0.001,5\n");
  EXPECT_THAT(message({"--measured", "bulk.csv", "--unknown", "binder.times"}),
              HasSubstr("stage discs has no reduced response under bulk"));
  study->write("prony.csv", "relaxation_time_s,modulus_Pa\n0.001,1e6\n");
  EXPECT_THAT(message({"--measured", "prony.csv", "--unknown", "binder.times"}),
              HasSubstr("a Prony series is a fit; expected measured values"));
  EXPECT_THAT(message({"--measured", "g.csv", "--unknown", "binder.times", "--stage", "disks"}),
              HasSubstr(R"(no response of a stage "disks")"));
}

}  // namespace
}  // namespace breccia::test
