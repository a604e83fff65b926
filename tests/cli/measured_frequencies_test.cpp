// A homogeneous box of one Maxwell element, G' = G x^2 / (1 + x^2) and G'' = G x / (1 + x^2) with x = omega tau: what
// is measured of it is what is computed, in every unit and in every table.

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "page/sweep_report.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test::measured_frequencies {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

constexpr double modulus = 2e6, relaxation_time = 0.1, per_cycle = 2.0 * std::numbers::pi;

constexpr std::string_view deck = R"(title = "Maxwell"

[materials.binder]
density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { terms = [{ time = "0.1 s", modulus = "2 MPa" }] }
temperature_shift = { law = "wlf", c1 = 14.0, c2 = "120 K", reference = "20 degC", temperature = "20 degC" }

[[stages]]
name    = "box"
matrix  = "binder"
box     = "6 mm"
cells   = 4

[tests]
frequencies = ["0.1 Hz", "100 Hz"]
boundaries = ["periodic"]
fields = "none"

[[measurements]]
name = "rheometer"
shear = { measured = "measured.csv" }
)";

/// Within the moduli of the binder that the run has sampled, but for the tolerance.
constexpr std::string_view softer = R"(density = "1 g/cm^3"
bulk = "3 GPa"
shear = { terms = [{ time = "0.1 s", modulus = "1.95 MPa" }] }
)";

/// The moduli at eleven frequencies from 0.1 to 215 Hz, the last one beyond those of the deck.
std::string measured(const std::string& column, double unit) {
  auto table = column + ",shear_storage_modulus_kPa,tan_delta\n";
  for (int k = -3; k <= 7; ++k) {
    const double omega = per_cycle * std::pow(10.0, k / 3.0), x = omega * relaxation_time;
    table += fmt::format("{},{},{}\n", omega / unit, 1e-3 * modulus * x * x / (1.0 + x * x), 1.0 / x);
  }
  return table;
}

class MeasuredFrequencies : public ::testing::Test {
 protected:
  MeasuredFrequencies() : study(deck) {
    study.write("measured.csv", measured("frequency_Hz", per_cycle));
    study.write("softer.toml", softer);
  }

  Outcome run(const std::vector<std::string>& more = {}) {
    auto outcome = study.breccia("run", more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return outcome;
  }
  [[nodiscard]] Outcome respond(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"respond", "out", "--material", "softer.toml"});
    return run_breccia(study.path(), more);
  }
  [[nodiscard]] CsvTable compared(const std::string& file) const {
    return read_csv(study.path() / file, {"measurement", "modulus", "stage", "boundary", "method", "cells", "error"});
  }

  StudyDirectory study;
};

TEST_F(MeasuredFrequencies, AgreeInEveryUnit) {
  for (const auto& [column, unit] : {std::pair{"frequency_Hz", per_cycle},
                                     {"Frequency (kHz)", 1e3 * per_cycle},
                                     {"angular_frequency_rad_per_s", 1.0},
                                     {"omega [krad/s]", 1e3}}) {
    study.write("measured.csv", measured(column, unit));
    const auto outcome = run({"--overwrite"});
    EXPECT_THAT(outcome.output, HasSubstr("\nbox, periodic, quasistatic, over what was measured, rheometer\n"
                                          "   frequency     |G*|       phase"))
        << column;
    EXPECT_THAT(outcome.output, HasSubstr("  |G*|: nearest 1.000 at "));
    EXPECT_THAT(outcome.output, HasSubstr("        1 Hz    1.000  "));
    const auto table = compared("out/comparison_dynamic.csv");
    EXPECT_EQ(table.rows(), 10U) << "the frequencies of the deck";
    for (const auto* ratio : {"ratio", "storage_ratio", "loss_ratio"}) {
      EXPECT_THAT(table.numbers(ratio), Each(DoubleNear(1.0, 1e-6))) << column;
    }
    EXPECT_THAT(table.numbers("phase_difference_deg"), Each(DoubleNear(0.0, 1e-4)));
    EXPECT_NEAR(table.numbers("frequency_Hz")[3] / 1.0, 1.0, 1e-9);
    const double x = per_cycle * relaxation_time;
    EXPECT_NEAR(table.numbers("measured_loss_modulus_Pa")[3] / (modulus * x / (1.0 + x * x)), 1.0, 1e-9);
  }
  const auto record = nlohmann::json::parse(read_text(study.result("study.json")));
  const auto& comparison = record.at("stages").at(0).at("comparisons").at(0);
  EXPECT_NEAR(comparison.at("worst_in_frequency").at("ratio").get<double>(), 1.0, 1e-6);
}

TEST_F(MeasuredFrequencies, OfSeveralTemperaturesAreComparedAtTheReference) {
  // The same element at 20 and at 40 degC, where its relaxation time is a tenth.
  std::string table = "temperature_degC,frequency_Hz,shear_storage_modulus_Pa,shear_loss_modulus_Pa\n";
  for (const double celsius : {20.0, 40.0}) {
    for (int k = -2; k <= 4; ++k) {
      const double hertz = std::pow(10.0, k / 2.0),
                   x = per_cycle * hertz * relaxation_time * (celsius > 30.0 ? 0.1 : 1.0);
      table +=
          fmt::format("{},{},{},{}\n", celsius, hertz, modulus * x * x / (1.0 + x * x), modulus * x / (1.0 + x * x));
    }
  }
  study.write("measured.csv", table);
  run({"--set", R"(measurements.0.shear.reference_temperature="20 degC")"});
  const auto found = compared("out/comparison_dynamic.csv");
  EXPECT_GT(found.rows(), 7U) << "frequencies of both temperatures";
  EXPECT_THAT(found.numbers("ratio"), Each(DoubleNear(1.0, 1e-3)));
  const auto warmer = study.breccia("check", {"--set", R"(measurements.0.shear.reference_temperature="20 degC")",
                                              "--set", R"(materials.binder.temperature_shift.temperature="40 degC")"});
  EXPECT_THAT(warmer.output + warmer.errors,
              HasSubstr("reference_temperature: the measured modulus is at 293.15 K, and "
                        "binder is at 313.15 K"));
}

TEST_F(MeasuredFrequencies, StandBesideAnAnswer) {
  run();
  const auto answer = respond();
  ASSERT_EQ(answer.exit_code, 0) << answer.errors;
  EXPECT_THAT(answer.output, HasSubstr("\nbox, G, periodic, quasistatic\n   frequency          |G*|"));
  EXPECT_THAT(answer.output, HasSubstr("        1 Hz    0.975  "));
  EXPECT_THAT(answer.output, Not(HasSubstr("        time")));
  EXPECT_THAT(compared("out/respond-softer/comparison_dynamic.csv").numbers("ratio"), Each(DoubleNear(0.975, 1e-5)));
  const auto table =
      read_csv(study.result("respond-softer/dynamic.csv"), {"stage", "load", "boundary", "method", "cells", "error"});
  EXPECT_NEAR(table.numbers("angular_frequency_rad_per_s")[20] / per_cycle, 1.0, 1e-9)
      << "whole parts of decades in Hz";
}

TEST_F(MeasuredFrequencies, AnAnswerIsOverWhatIsAskedFor) {
  run();
  const auto in_time = respond({"--times", "10 ms", "1 s", "--out", "times"});
  ASSERT_EQ(in_time.exit_code, 0) << in_time.errors;
  EXPECT_THAT(in_time.output, AllOf(HasSubstr("        time"), HasSubstr("\nbox over what was measured, rheometer"),
                                    Not(HasSubstr("frequency"))));
  const auto some = respond({"--frequencies", "1 Hz", "10 Hz", "--out", "frequencies"});
  ASSERT_EQ(some.exit_code, 0) << some.errors;
  EXPECT_THAT(some.output, AllOf(HasSubstr("       10 Hz  "), Not(HasSubstr("      100 Hz  "))));
  EXPECT_EQ(compared("frequencies/comparison_dynamic.csv").rows(), 4U);
  const auto both = respond({"--times", "10 ms", "1 s", "--frequencies", "1 Hz", "10 Hz"});
  EXPECT_THAT(both.errors, HasSubstr("--times excludes --frequencies"));
  EXPECT_NE(both.exit_code, 0);
  EXPECT_THAT(respond({"--frequencies", "10 Hz", "1 Hz"}).errors,
              HasSubstr("--frequencies: expected two rising frequencies, got 10 Hz and 1 Hz"));
  EXPECT_THAT(respond({"--frequencies", "1 s", "2 s"}).errors, HasSubstr("--frequencies: expected a frequency"));
}

TEST_F(MeasuredFrequencies, AreNotThoseOfAnotherTemperature) {
  run();
  const auto answer =
      run_breccia(study.path(), {"respond", "out", "--temperature", "22 degC", "--frequencies", "1 Hz", "10 Hz"});
  ASSERT_EQ(answer.exit_code, 0) << answer.errors;
  EXPECT_THAT(answer.output, Not(HasSubstr("measured")));
}

TEST_F(MeasuredFrequencies, AreComparedInAStudyOverTime) {
  const auto outcome = run({"--set", "tests.frequencies=", "--set", R"(tests.times=["1 ms", "1 s"])"});
  EXPECT_THAT(outcome.output, HasSubstr("\nbox over what was measured, rheometer\n"));
  EXPECT_THAT(compared("out/comparison_dynamic.csv").numbers("ratio"), Each(DoubleNear(1.0, 1e-6)));
}

TEST_F(MeasuredFrequencies, WarningsSpeakOfFrequencies) {
  const auto outcome = run({"--set", R"(tests.frequencies=["1 mHz", "100 Hz"])"});
  EXPECT_THAT(
      outcome.output + outcome.errors,
      HasSubstr("frequencies begin at 1 mHz, more than a decade below that of the slowest relaxation time of its "
                "matrix, binder, 1.59 Hz; it has no equilibrium modulus"));
  EXPECT_THAT(outcome.output + outcome.errors, Not(HasSubstr("times end")));
}

TEST_F(MeasuredFrequencies, PointsBeyondThoseOfTheDeckAreCounted) {
  EXPECT_THAT(
      run({"--quiet"}).errors,
      HasSubstr("warning: box: 1 of the 11 points of the measurement \"rheometer\" is not compared: it is known "
                "from 100 mHz to 215 Hz, and tests.frequencies go from 100 mHz to 100 Hz"));
}

/// The complex Young's modulus of the binder, with K = 3 GPa, at eleven frequencies from 0.1 to 215 Hz.
std::string measured_in_tension() {
  std::string table = "frequency_Hz,youngs_storage_modulus_MPa,youngs_loss_modulus_MPa\n";
  for (int k = -3; k <= 7; ++k) {
    const std::complex<double> x(0.0, per_cycle * std::pow(10.0, k / 3.0) * relaxation_time);
    const auto shear = modulus * x / (1.0 + x), young = 9.0 * 3e9 * shear / (9e9 + shear);
    table += fmt::format("{},{},{}\n", std::pow(10.0, k / 3.0), 1e-6 * young.real(), 1e-6 * young.imag());
  }
  return table;
}

TEST_F(MeasuredFrequencies, InTensionAreThoseOfYoungsModulus) {
  study.write("tension.csv", measured_in_tension());
  const auto outcome = run({"--set", "measurements.0.shear=", "--set", R"(measurements.0.young.measured="tension.csv")",
                            "--set", R"(tests.loads=["shear"])"});
  EXPECT_THAT(outcome.output,
              AllOf(HasSubstr("over what was measured, rheometer\n   frequency     |E*|       phase"),
                    HasSubstr("  |E*|: nearest 1.000 at "), HasSubstr("; error of the computed modulus ")));
  const auto table = compared("out/comparison_dynamic.csv");
  EXPECT_THAT(table.text("modulus"), AllOf(SizeIs(10), Each("young")));
  EXPECT_THAT(table.numbers("ratio"), Each(DoubleNear(1.0, 1e-6)));
  EXPECT_THAT(table.numbers("phase_difference_deg"), Each(DoubleNear(0.0, 1e-4)));
  const auto document = nlohmann::json::parse(read_text(study.result("study.json")));
  EXPECT_EQ(document.at("stages").at(0).at("comparisons").at(0).at("modulus"), "young");
  const auto answer = respond();
  ASSERT_EQ(answer.exit_code, 0) << answer.errors;
  EXPECT_THAT(compared("out/respond-softer/comparison_dynamic.csv").numbers("ratio"), Each(DoubleNear(0.975, 1e-3)));
  const auto in_time =
      run({"--overwrite", "--set", "measurements.0.shear=", "--set", R"(measurements.0.young.measured="tension.csv")",
           "--set", "tests.frequencies=", "--set", R"(tests.times=["10 ms", "1 s"])"});
  EXPECT_THAT(in_time.output, HasSubstr("\nbox, Young's modulus, over what was measured, rheometer\n"));
}

TEST_F(MeasuredFrequencies, AreOfOneKindOfModulus) {
  study.write("tension.csv", measured_in_tension());
  const auto both = study.breccia("check", {"--set", R"(measurements.0.young.measured="tension.csv")"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_THAT(both.errors, HasSubstr("expected exactly one of shear, young, bulk, got shear and young"));
  const auto other = study.breccia("check", {"--set", R"(measurements.0.shear.measured="tension.csv")"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.errors, HasSubstr("Young's modulus"));
  const auto none = study.breccia("check", {"--set", "measurements.0.shear="});
  EXPECT_THAT(none.errors, HasSubstr("expected exactly one of shear, young, bulk"));
}

// Twice the modulus has twice the absolute value and the same phase.
TEST_F(MeasuredFrequencies, ASweepAnswersInFrequency) {
  const auto outcome = run({"--sweep", R"(materials.binder.shear.terms.0.modulus=["2 MPa", "4 MPa"])"});
  EXPECT_THAT(outcome.output,
              AllOf(HasSubstr("Absolute value and phase of the modulus of the last stage"), HasSubstr("frequency"),
                    ContainsRegex("   10 Hz +1.98 MPa +9.04 deg +3.95 MPa +9.04 deg")));
  const auto table = read_csv(
      study.result("sweep_dynamic.csv"),
      {"task", "materials.binder.shear.terms.0.modulus", "stage", "load", "boundary", "method", "cells", "error"});
  const auto& omega = table.numbers("angular_frequency_rad_per_s");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double x = omega[row] * relaxation_time, size = table.text("task")[row] == "modulus-2-MPa" ? 1.0 : 2.0;
    ASSERT_THAT(table.numbers("storage_modulus_Pa")[row] / (size * modulus * x * x / (1.0 + x * x)),
                DoubleNear(1.0, 1e-6));
    ASSERT_THAT(table.numbers("loss_tangent")[row] * x, DoubleNear(1.0, 1e-6));
  }
  const auto data = nlohmann::json::parse(sweep_page_data(study.path() / "out").json);
  EXPECT_EQ(data.at("curves").at(0).at("angular_frequency_rad_per_s").size(), table.rows() / 6);
  const auto& beside = data.at("measurements_in_frequency").at(0);
  EXPECT_EQ(beside.at("measurement"), "rheometer");
  EXPECT_EQ(beside.at("measured_storage_modulus_Pa").size(), 10U);
  EXPECT_THAT(read_text(study.result("sweep.svg")),
              AllOf(HasSubstr("|G*|"), HasSubstr("Frequency / Hz"), HasSubstr("measured, rheometer")));
  const auto page = read_text(study.result("report.html"));
  EXPECT_EQ(run_breccia(study.path(), {"report", "out"}).exit_code, 0);
  EXPECT_EQ(read_text(study.result("report.html")), page) << "the page from the files is that of the run";
}

}  // namespace
}  // namespace breccia::test::measured_frequencies
