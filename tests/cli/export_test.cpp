// Tests of `breccia export` for runs in two and three dimensions: cards are read back and compared with the curves of
// the run.

#include <algorithm>
#include <cmath>
#include <memory>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/text_file.hpp"
#include "results/card_parsers.hpp"
#include "results/material_card.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

constexpr std::string_view composite_deck = R"(title = "Composite"

[materials.binder]
density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { terms = [
  { time = "10 us", modulus = "80 MPa" }, { time = "1 ms", modulus = "10 MPa" }, { time = "100 ms", modulus = "2 MPa" },
  { time = "10 s", modulus = "1 MPa" }], equilibrium = "1 MPa" }
temperature_shift = { law = "wlf", c1 = 14.0, c2 = "120 K", reference = "20 degC", temperature = "30 degC" }

[materials.particle]
density = "2 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"

[[stages]]
name    = "fine"
matrix  = "binder"
box     = "6 mm"
cells   = 12
filler  = { material = "particle", sizes = { diameter = "2 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }

[[stages]]
name    = "coarse"
matrix  = "fine"
box     = "60 mm"
cells   = 12
filler  = { material = "particle", sizes = { diameter = "20 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }

[tests]
loads  = ["shear", "bulk"]
times  = ["10 us", "10 s"]
fields = "none"
)";

class Export : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    study = std::make_unique<StudyDirectory>(composite_deck);
    const auto run = study->breccia("run");
    ASSERT_EQ(run.exit_code, 0) << run.errors;
  }
  static void TearDownTestSuite() { study.reset(); }

  static Outcome export_card(const std::string& format, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"export", "out", "--format", format});
    return run_breccia(study->path(), more);
  }
  /// The curve under the displacement boundary.
  static Curve curve(const std::string& stage, const std::string& load) {
    const auto table = read_csv(study->result("curves.csv"), {"stage", "load", "boundary", "method", "cells"});
    Curve samples;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const bool is_of_it = table.text("stage")[row] == stage && table.text("load")[row] == load &&
                            table.text("boundary")[row] == "displacement";
      if (is_of_it) samples.push_back({table.numbers("time_s")[row], table.numbers("modulus_Pa")[row]});
    }
    return samples;
  }

  static std::unique_ptr<StudyDirectory> study;
};

std::unique_ptr<StudyDirectory> Export::study;

double deviation_from(const Curve& curve, const PronySeries& series) {
  double largest = 0.0;
  for (const auto& [time, modulus] : curve) largest = std::max(largest, std::abs(series.at(time) / modulus - 1.0));
  return largest;
}

TEST_F(Export, WritesEveryFormatWithinTheTolerance) {
  const auto shear = curve("coarse", "shear");
  ASSERT_FALSE(shear.empty());
  for (const auto& [word, value] : words<CardFormat>) {
    const std::string format(word);
    const auto written = export_card(format, {"--boundary", "displacement", "--poisson", "0.3"});
    ASSERT_EQ(written.exit_code, 0) << format << written.errors;
    const auto card = parse_card(format, written.output);
    const double deviation = deviation_from(shear, card.shear);
    RecordProperty(format, std::to_string(deviation));
    EXPECT_LT(deviation, 0.0101) << format;
    EXPECT_NEAR(card.bulk.at(1e-3) / card.shear.at(1e-3), 2.6 / 1.2, 1e-4) << format;
    EXPECT_THAT(written.output, HasSubstr("plane strain"));
    // The two stages are equal and have the same filler: the binder's share of the whole is the square of its share in
    // one stage.
    const double share = 1.0 - 4.0 * std::acos(-1.0) / 36.0;
    EXPECT_NEAR(card.density, 1000.0 * share * share + 2000.0 * (1.0 - share * share), 0.5) << format;
  }
}

TEST_F(Export, TakesTheBulkModulusFromTheBulkTest) {
  const auto written = export_card("csv", {"--boundary", "displacement", "--tolerance", "5 %"});
  ASSERT_EQ(written.exit_code, 0) << written.errors;
  const auto card = parse_card("csv", written.output);
  const auto shear = curve("coarse", "shear"), dilatational = curve("coarse", "bulk");
  for (std::size_t i = 0; i < shear.size(); ++i) {
    const double bulk = dilatational[i].modulus - shear[i].modulus / 3.0;
    EXPECT_NEAR(card.bulk.at(shear[i].time) / bulk, 1.0, 0.051);
  }
}

TEST_F(Export, WritesToAFileAndNotOverOne) {
  const auto written = export_card("abaqus", {"--boundary", "traction", "--stage", "fine", "--bulk", "5 GPa",
                                              "--output", "card.inp", "--units", "mm-t-s"});
  ASSERT_EQ(written.exit_code, 0) << written.errors;
  EXPECT_THAT(written.output, HasSubstr("fine: G(t) within"));
  EXPECT_THAT(written.output, HasSubstr("The card is in card.inp"));
  const auto card = parse_card("abaqus", read_text(study->path() / "card.inp"));
  EXPECT_NEAR(card.bulk.at(0.0), 5000.0, 1e-6);  // MPa
  ASSERT_TRUE(card.shift);
  EXPECT_NEAR(card.shift->reference_temperature, 303.15, 1e-9);
  EXPECT_NEAR(card.shift->c2, 130.0, 1e-9);
  EXPECT_NEAR(card.shift->c1, 14.0 * 120.0 / 130.0, 1e-9);
  const auto again = export_card("abaqus", {"--boundary", "traction", "--bulk", "5 GPa", "--output", "card.inp"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.errors, HasSubstr("--overwrite"));
  EXPECT_EQ(export_card("csv", {"--boundary", "traction", "--bulk", "5 GPa", "--output", "card.inp", "--overwrite"})
                .exit_code,
            0);
}

TEST_F(Export, RefusesOptionsOfOtherFormats) {
  const auto table = export_card("dma", {"--boundary", "displacement", "--units", "mm-t-s", "--poisson", "0.4"});
  EXPECT_EQ(table.exit_code, 2);
  EXPECT_THAT(table.errors, HasSubstr("--units: the format dma has none"));
  EXPECT_THAT(table.errors, HasSubstr("--poisson: the format dma has none"));
  const auto card = export_card("abaqus", {"--boundary", "displacement", "--step", "1 K"});
  EXPECT_EQ(card.exit_code, 2);
  EXPECT_THAT(card.errors, HasSubstr("--step: the format abaqus has none"));
}

TEST_F(Export, CsvServesAsTheMaterialOfADeck) {
  ASSERT_EQ(export_card("csv", {"--boundary", "displacement", "--poisson", "0.3", "--output", "terms.csv"}).exit_code,
            0);
  const StudyDirectory next(R"([materials.composite]
density = "1.6 g/cm^3"
bulk    = { prony = "terms.csv" }
shear   = { prony = "terms.csv" }
[[stages]]
name = "again"
matrix = "composite"
box = "1 m"
cells = 2
[tests]
loads = ["shear"]
times = ["10 us", "10 s"]
)");
  next.write("terms.csv", read_text(study->path() / "terms.csv"));
  const auto run = next.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto once = curve("coarse", "shear"), again = read_curve(next.result("curves.csv"), "again", "shear");
  for (const auto& [time, modulus] : once) EXPECT_NEAR(modulus_at(again, time) / modulus, 1.0, 0.011);
}

TEST_F(Export, SaysWhatThereIsToChooseFrom) {
  const auto open = export_card("abaqus");
  EXPECT_EQ(open.exit_code, 2);
  EXPECT_THAT(open.errors, HasSubstr("several boundary conditions; choose one: displacement, traction"));
  const auto stage = export_card("abaqus", {"--stage", "coarsse"});
  EXPECT_EQ(stage.exit_code, 2);
  EXPECT_THAT(stage.errors, HasSubstr("did you mean \"coarse\"?"));
  const auto both = export_card("abaqus", {"--load", "shear-yz"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_THAT(both.errors, HasSubstr("several boundary conditions"));
  EXPECT_THAT(both.errors, HasSubstr("not tested under the shear load shear-yz"));
}

TEST_F(Export, ReportsAllMistakesOfItsOptionsAtOnce) {
  const auto outcome = export_card("abaqus", {"--tolerance", "one", "--times", "1 s", "1 us", "--bulk", "3 mm",
                                              "--poisson", "0.7", "--output", "out"});
  EXPECT_EQ(outcome.exit_code, 2);
  for (const auto* option :
       {"--tolerance: ", "--times: ", "--bulk: ", "--poisson: ", "--bulk and --poisson: ", "--output: "}) {
    EXPECT_THAT(outcome.errors, HasSubstr(option));
  }
  EXPECT_EQ(outcome.output, "");
}

/// At the temperature of the study the moduli are those of dynamic.csv; at another temperature they are those of a run
/// at it.
TEST_F(Export, DynamicModuliAgainstTemperature) {
  const auto outcome = export_card("dma", {"--boundary", "displacement", "--frequency", "10 Hz", "--temperatures",
                                           "10 degC", "30 degC", "--step", "20 K", "--output", "dma.csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("2 temperatures at 10 Hz"));
  const auto table = read_csv(study->path() / "dma.csv");
  EXPECT_THAT(table.numbers("temperature_degC"),
              ::testing::ElementsAre(::testing::DoubleNear(10.0, 1e-9), ::testing::DoubleNear(30.0, 1e-9)));
  EXPECT_NEAR(table.numbers("log10_shift_factor")[1], 0.0, 1e-12);
  const StudyDirectory cold(composite_deck);
  const auto run = cold.breccia("run", {"--set", "materials.binder.temperature_shift.temperature=10 degC"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto there =
      run_breccia(cold.path(), {"export", "out", "--format", "dma", "--boundary", "displacement", "--frequency",
                                "10 Hz", "--temperatures", "10 degC", "12 degC", "--output", "dma.csv"});
  ASSERT_EQ(there.exit_code, 0) << there.errors;
  const auto expected = read_csv(cold.path() / "dma.csv");
  for (const auto* column : {"shear_storage_modulus_Pa", "shear_loss_modulus_Pa", "youngs_storage_modulus_Pa",
                             "youngs_loss_modulus_Pa", "poisson_ratio_real"}) {
    // Tolerance of two reduced bases.
    EXPECT_NEAR(table.numbers(column)[0] / expected.numbers(column)[0], 1.0, 3e-3) << column;
  }
}

TEST_F(Export, RefusesTemperaturesThatTheRunDoesNotCover) {
  const auto outcome = export_card("dma", {"--boundary", "displacement", "--temperatures", "-80 degC", "30 degC"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors,
              ::testing::ContainsRegex(
                  "the times of the study, 1e-05 to 10 s, and the shift factors of its binder cover .* degC"));
  const auto options =
      export_card("dma", {"--frequency", "1 m", "--temperatures", "30 degC", "20 degC", "--step", "0 K"});
  EXPECT_EQ(options.exit_code, 2);
  for (const auto* option : {"--frequency: ", "--temperatures: ", "--step: "}) {
    EXPECT_THAT(options.errors, HasSubstr(option));
  }
  // At this frequency the times cover -27 to -2 degC, between two multiples of 50.
  const auto empty = export_card("dma", {"--boundary", "displacement", "--frequency", "1e-6 Hz", "--step", "50 K"});
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_THAT(empty.errors, ::testing::ContainsRegex("cover -27.* to -1.* degC only, without a multiple of 50 K"));
}

TEST_F(Export, RefusesUnknownFormatsAndDirectories) {
  const auto format = export_card("nastran");
  EXPECT_EQ(format.exit_code, 2);
  EXPECT_THAT(format.errors, HasSubstr("ls-dyna"));
  const auto nowhere = run_breccia(study->path(), {"export", "nowhere", "--format", "csv"});
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_THAT(nowhere.errors, HasSubstr("no such directory"));
  const auto empty = run_breccia(study->path(), {"export", ".", "--format", "csv"});
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_THAT(empty.errors, HasSubstr("no prony.csv"));
  const auto without = run_breccia(study->path(), {"export", "out"});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_THAT(without.errors, HasSubstr("--format"));
}

/// After a typing error, MPa for GPa, the card is written, and the error stream has a warning about the odd value.
TEST_F(Export, WarnsOfAnOddPoissonsRatio) {
  const auto outcome = export_card("abaqus", {"--boundary", "displacement", "--bulk", "1 MPa"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.errors, HasSubstr("warning: coarse: Poisson's ratio of the card is -0.9"));
  EXPECT_THAT(outcome.errors, HasSubstr("K = 1 MPa"));
  EXPECT_EQ(outcome.output.find("warning: "), std::string::npos);
  EXPECT_EQ(export_card("abaqus", {"--boundary", "displacement", "--poisson", "0.3"}).errors, "");
}

/// The card at another temperature agrees with that of a run at this temperature.
TEST_F(Export, ComputesTheCardAtAnotherTemperature) {
  const std::vector<std::string> options = {"--boundary", "traction", "--poisson", "0.3", "--tolerance", "0.1 %"};
  auto at_temperature = options;
  at_temperature.insert(at_temperature.end(), {"--temperature", "40 degC"});
  const auto warm = export_card("csv", at_temperature);
  ASSERT_EQ(warm.exit_code, 0) << warm.errors;
  EXPECT_THAT(warm.output, HasSubstr("Composite at 40 degC, stage coarse"));
  EXPECT_THAT(warm.output, HasSubstr("At 313.15 K"));
  const StudyDirectory there(composite_deck);
  const auto run = there.breccia("run", {"--set", "materials.binder.temperature_shift.temperature=40 degC"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  auto arguments = options;
  arguments.insert(arguments.begin(), {"export", "out", "--format", "csv"});
  const auto expected = run_breccia(there.path(), arguments);
  ASSERT_EQ(expected.exit_code, 0) << expected.errors;
  const auto card = parse_card("csv", warm.output), card_there = parse_card("csv", expected.output);
  const auto at_run = parse_card("csv", export_card("csv", options).output);
  EXPECT_GT(at_run.shear.at(1e-3) / card_there.shear.at(1e-3), 1.1) << "the temperature makes a difference";
  for (const double time : {1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0, 10.0}) {
    // The tolerance is twice that of the cards plus that of two reduced bases.
    EXPECT_NEAR(card.shear.at(time) / card_there.shear.at(time), 1.0, 2e-3 + 1e-3) << time;
  }
  EXPECT_NEAR(card.density, card_there.density, 1e-6);
}

/// The lines of a text with warnings.
std::vector<std::string> warnings_in(const std::string& text) {
  std::vector<std::string> warnings;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("warning: ")) warnings.push_back(line);
  }
  return warnings;
}

/// At 150 degC the binder has relaxed long before the last time of the run.
TEST_F(Export, WarnsAtATemperatureAsRespondDoes) {
  const auto respond = run_breccia(study->path(), {"respond", "out", "--temperature", "150 degC", "--out", "hot"});
  ASSERT_EQ(respond.exit_code, 0) << respond.errors;
  const auto expected = warnings_in(respond.output);
  EXPECT_THAT(expected, Contains(HasSubstr("of its matrix, binder at 150 degC, ")));
  const auto card = export_card("csv", {"--boundary", "traction", "--poisson", "0.3", "--temperature", "150 degC"});
  ASSERT_EQ(card.exit_code, 0) << card.errors;
  EXPECT_THAT(warnings_in(card.errors), IsSupersetOf(expected));
}

// A run of two grids that ended after the first one has the file of one grid: its card is written, with a warning.
TEST_F(Export, WarnsOfARunThatIsNotComplete) {
  const auto record = study->result("study.json");
  const auto whole = read_text(record);
  write_text(record, std::regex_replace(whole, std::regex("\"complete\": true"), "\"complete\": false"));
  const std::vector<std::string> asked = {"--boundary", "traction", "--poisson", "0.3"};
  auto warm = asked;
  warm.insert(warm.end(), {"--temperature", "40 degC"});
  for (const auto& arguments : {asked, warm}) {
    const auto card = export_card("csv", arguments);
    EXPECT_EQ(card.exit_code, 0);
    EXPECT_THAT(card.errors, HasSubstr("warning: out: the run is not complete"));
  }
  write_text(record, whole);
  EXPECT_THAT(export_card("csv", asked).errors, Not(HasSubstr("not complete")));
}

// By default the last stage of the deck is exported, at any temperature. In this deck the alphabetical order of the
// stages differs from their order in the deck.
TEST(ExportAtATemperature, TakesTheLastStageOfTheDeck) {
  const auto deck =
      std::regex_replace(std::string(composite_deck), std::regex("name    = \"coarse\"\nmatrix  = \"fine\""),
                         "name    = \"acid\"\nmatrix  = \"binder\"");
  const StudyDirectory study(deck);
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const std::vector<std::string> asked = {"export", "out", "--format", "csv", "--boundary", "traction"};
  auto warm = asked;
  warm.insert(warm.end(), {"--temperature", "40 degC"});
  for (const auto& arguments : {asked, warm}) {
    const auto card = run_breccia(study.path(), arguments);
    EXPECT_THAT(card.output, HasSubstr("stage acid:")) << card.errors;
  }
}

// The responses hold only for the moduli that the materials have within the times of the run; a much warmer binder has
// other moduli. The message advises the option with which the card can be written.
TEST(ExportAtATemperature, NamesTheCoveredTimes) {
  std::string deck(composite_deck);
  const auto coarse = deck.find("[[stages]]\nname    = \"coarse\"");
  deck.erase(coarse, deck.find("[tests]") - coarse);
  deck.replace(deck.find("\"10 s\"]"), 6, "\"1 ms\"");
  const StudyDirectory study(deck + "[tests.quasistatic]\nrange = \"times\"\n");
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  std::vector<std::string> asked = {"export",    "out", "--format",    "csv", "--boundary",    "traction",
                                    "--poisson", "0.3", "--tolerance", "2 %", "--temperature", "60 degC"};
  const auto refused = run_breccia(study.path(), asked);
  EXPECT_EQ(refused.exit_code, 2);
  static const std::regex advice("covered from .*: --times \"([^\"]*)\" \"([^\"]*)\"");
  std::smatch times;
  ASSERT_TRUE(std::regex_search(refused.errors, times, advice)) << refused.errors;
  asked.insert(asked.end(), {"--times", times[1], times[2]});
  const auto covered = run_breccia(study.path(), asked);
  EXPECT_EQ(covered.exit_code, 0) << covered.errors;
}

TEST_F(Export, RefusesTemperaturesWithoutALaw) {
  const auto unit = export_card("csv", {"--boundary", "traction", "--poisson", "0.3", "--temperature", "40 m"});
  EXPECT_EQ(unit.exit_code, 2);
  EXPECT_THAT(unit.errors, HasSubstr("--temperature: "));
  const auto cold = export_card("csv", {"--boundary", "traction", "--poisson", "0.3", "--temperature", "-150 degC"});
  EXPECT_EQ(cold.exit_code, 2);
  const auto table = export_card("dma", {"--boundary", "traction", "--temperature", "40 degC"});
  EXPECT_EQ(table.exit_code, 2);
  EXPECT_THAT(table.errors, HasSubstr("--temperature: the format dma has none"));
}

TEST_F(Export, SaysWhereTheCardOfOtherCurvesIsFrom) {
  const auto respond = run_breccia(study->path(), {"respond", "out", "--temperature", "40 degC", "--out", "warm"});
  ASSERT_EQ(respond.exit_code, 0) << respond.errors;
  const auto outcome = run_breccia(study->path(), {"export", "warm", "--format", "csv"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("warm: curves of an answered response"));
  EXPECT_THAT(outcome.errors, HasSubstr("name the results that they were answered from, with --temperature"));
}

/// The times of the run cover more than 100 K on one side of its temperature.
TEST_F(Export, TakesTemperaturesNearThatOfTheRun) {
  const auto outcome = export_card(
      "dma", {"--boundary", "displacement", "--frequency", "0.1 Hz", "--step", "5 K", "--output", "near.csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto table = read_csv(study->path() / "near.csv");
  EXPECT_GE(table.numbers("temperature_K").front(), 303.15 - 100.0);
  EXPECT_LE(table.numbers("temperature_K").back(), 303.15 + 100.0 + 1e-6);
  EXPECT_LE(table.rows(), 41U);
}

TEST_F(Export, RefusesMoreTermsThanLsDynaTakes) {
  const auto outcome =
      export_card("ls-dyna", {"--boundary", "displacement", "--poisson", "0.3", "--tolerance", "0.00000001 %"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("LS-DYNA takes at most 17 terms"));
}

}  // namespace
}  // namespace breccia::test
