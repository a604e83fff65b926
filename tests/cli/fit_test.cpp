#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/viscoelasticity/creep_law.hpp"
#include "breccia/viscoelasticity/relaxation_law.hpp"

#include "command.hpp"
#include "deck/prony_file.hpp"
#include "good_deck.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "report/xml.hpp"
#include "tables/csv.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using ::testing::HasSubstr;
using Function = std::function<double(double)>;

const std::filesystem::path data = std::filesystem::path(BRECCIA_EXAMPLES_DIRECTORY) / ".." / "data";

std::vector<double> logarithmic(double first, double last, int per_decade) {
  std::vector<double> values;
  const int count = static_cast<int>(std::lround(per_decade * std::log10(last / first)));
  for (int i = 0; i <= count; ++i) values.push_back(first * std::pow(10.0, static_cast<double>(i) / per_decade));
  return values;
}

class Fit : public ::testing::Test {
 protected:
  [[nodiscard]] test::Outcome run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "fit");
    return test::run_breccia(directory.path(), arguments);
  }
  [[nodiscard]] CsvTable result(const std::string& name) const { return read_csv(directory.path() / name); }

  /// Writes a file with two columns: times, and the value at each.
  void write_curve(const std::string& name, const std::string& header, const std::vector<double>& at,
                   const Function& function) const {
    std::string text = header + "\n";
    for (const double x : at) text += fmt::format("{},{}\n", x, function(x));
    directory.write(name, text);
  }

  test::TemporaryDirectory directory;
};

/// The largest relative difference of a column from a function of another column.
double worst_difference(const CsvTable& table, const std::string& at, const std::string& column,
                        const Function& function) {
  double worst = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    worst = std::max(worst, std::abs(table.numbers(column)[row] / function(table.numbers(at)[row]) - 1.0));
  }
  return worst;
}

// A standard linear solid: springs of 2 MPa and 6 MPa, the latter with a dashpot of 0.3 s.
constexpr double spring = 2e6, maxwell = 6e6, tau = 0.3;
double relaxation(double t) {
  return spring + maxwell * std::exp(-t / tau);
}
double creep(double t) {
  return 1.0 / spring - (1.0 / spring - 1.0 / (spring + maxwell)) * std::exp(-t * spring / (tau * (spring + maxwell)));
}

TEST_F(Fit, RelaxationInOtherUnitsBecomesCreep) {
  write_curve("g.csv", "time_ms,shear_modulus_MPa", logarithmic(1.0, 1e5, 20),
              [](double ms) { return 1e-6 * relaxation(1e-3 * ms); });
  const auto outcome = run({"g.csv", "--to", "creep"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("Results are in results/g-fit: prony.csv, retardation.csv, fit.csv, creep.csv, "
                                        "fit.svg, creep.svg, material.toml, report.html"));
  EXPECT_LT(worst_difference(result("results/g-fit/creep.csv"), "time_s", "shear_compliance_1_per_Pa", creep), 3e-3);
  EXPECT_LT(worst_difference(result("results/g-fit/fit.csv"), "time_s", "fit_Pa", relaxation), 3e-3);
  for (const auto* name : {"fit.svg", "creep.svg"}) {
    EXPECT_EQ(test::xml_mistake(read_text(directory.path() / "results/g-fit" / name)), "");
  }
}

TEST_F(Fit, CreepBecomesRelaxation) {
  write_curve("j.csv", "time_s,compliance_1_per_MPa", logarithmic(1e-3, 1e2, 20),
              [](double t) { return 1e6 * creep(t); });
  const auto outcome = run({"j.csv", "--to", "relaxation", "--out", "there"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_LT(worst_difference(result("there/relaxation.csv"), "time_s", "modulus_Pa", relaxation), 0.01);
}

TEST_F(Fit, RampIsTakenOut) {
  // The stress after a strain that rises for 50 ms; for a step it would be 40 % off at the end of the ramp.
  const double ramp = 0.05;
  write_curve("g.csv", "time_s,modulus_Pa", logarithmic(5e-3, 10.0, 20), [&](double t) {
    const double end = std::min(t, ramp);
    return (spring * end + maxwell * tau * (std::exp(-(t - end) / tau) - std::exp(-t / tau))) / ramp;
  });
  const auto outcome = run({"g.csv", "--ramp", "50 ms"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_LT(worst_difference(result("results/g-fit/relaxation.csv"), "time_s", "modulus_Pa", relaxation), 0.02);
}

TEST_F(Fit, SeriesBecomeDynamic) {
  directory.write("maxwell.csv", "relaxation_time_s,modulus_Pa\n0.5,8e6\n");
  const auto outcome = run({"maxwell.csv", "--to", "dynamic"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("tan delta"));
  const auto table = result("results/maxwell-fit/dynamic.csv");
  const auto* at = "angular_frequency_rad_per_s";
  EXPECT_LT(worst_difference(table, at, "tan_delta", [](double omega) { return 2.0 / omega; }), 1e-12);
  EXPECT_LT(worst_difference(table, at, "loss_modulus_Pa",
                             [](double omega) { return 4e6 * omega / (1.0 + 0.25 * omega * omega); }),
            1e-12);
}

TEST_F(Fit, MasterCurveOfTheExampleIsTheBinder) {
  const auto outcome =
      run({(data / "synthetic_dma.csv").string(), "--reference-temperature", "19 degC", "--to", "relaxation"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("WLF: c1 = 6."));
  const auto file = read_prony_file(data / "pbx9501_binder_prony.csv");
  const PronySeries binder(0.0, file.terms);
  const auto at = [&](double t) { return binder.at(t); };
  EXPECT_LT(worst_difference(result("results/synthetic_dma-fit/relaxation.csv"), "time_s", "modulus_Pa", at), 0.03);
  const auto shifts = result("results/synthetic_dma-fit/shift_factors.csv");
  for (std::size_t row = 0; row < shifts.rows(); ++row) {
    const double difference = shifts.numbers("temperature_K")[row] - 292.15;
    EXPECT_NEAR(shifts.numbers("log10_shift_factor")[row], -6.5 * difference / (120.0 + difference), 0.03);
  }
}

TEST_F(Fit, ItsSeriesGoesIntoADeck) {
  write_curve("g.csv", "time_s,modulus_Pa", logarithmic(1e-3, 1e2, 10), relaxation);
  ASSERT_EQ(run({"g.csv", "--quiet"}).exit_code, 0);
  directory.write("deck.toml", test::replaced(std::string(test::good_deck),
                                              R"({ terms = [ { time = "10 ms", modulus = "1 MPa" } ] })",
                                              R"({ prony = "results/g-fit/prony.csv" })"));
  const auto check = test::run_breccia(directory.path(), {"check", "deck.toml"});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, ::testing::ContainsRegex("relaxing to (1[.]99|2[.]00)[0-9]* MPa"));
}

// The printed text can be copied into a deck; so can the table of shift factors.
TEST_F(Fit, ItsMaterialGoesIntoADeck) {
  const auto outcome = run({(data / "synthetic_dma.csv").string(), "--reference-temperature", "19 degC"});
  EXPECT_THAT(outcome.output, HasSubstr("    -41 degC        6.50"));
  const auto begin = outcome.output.find("shear = {"), end = outcome.output.find("\n\n", begin);
  ASSERT_NE(end, std::string::npos) << outcome.output;
  const auto keys = outcome.output.substr(begin, end - begin);
  EXPECT_THAT(keys, HasSubstr("temperature_shift = { law = \"wlf\", c1 = 6.4"));
  const auto deck_with = [&](const std::string& text) {
    directory.write("deck.toml",
                    test::replaced(std::string(test::good_deck),
                                   R"(shear   = { terms = [ { time = "10 ms", modulus = "1 MPa" } ] })", text));
    const auto check = test::run_breccia(directory.path(), {"check", "deck.toml"});
    EXPECT_EQ(check.exit_code, 0) << check.errors;
  };
  deck_with(keys);
  deck_with(
      "shear = { prony = \"results/synthetic_dma-fit/prony.csv\" }\ntemperature_shift = { law = \"table\", table = "
      "\"results/synthetic_dma-fit/shift_factors.csv\", reference = \"19 degC\", temperature = \"-41 degC\" }");
  const auto material = read_text(directory.path() / "results/synthetic_dma-fit/material.toml");
  EXPECT_THAT(material, HasSubstr("# density = "));
  EXPECT_THAT(material, HasSubstr("shear = { prony = \"prony.csv\" }\ntemperature_shift = { law = \"wlf\""));
}

// The complex modulus of a bitumen as 2S2P1D has it: the parameters come back, and a deck takes the law.
TEST_F(Fit, LawOfABitumenGoesIntoADeck) {
  const TwoSpringsTwoParabolasDashpot bitumen = {0.0, 1e9, 2.2, 2e-3, 0.22, 0.63, 50.0};
  std::string text = "frequency_Hz,storage_modulus_Pa,loss_modulus_Pa\n";
  for (const double frequency : logarithmic(1e-3, 1e4, 5)) {
    const auto modulus = carson_modulus(RelaxationLaw(bitumen), {0.0, 2.0 * std::numbers::pi * frequency});
    text += fmt::format("{},{},{}\n", frequency, modulus.real(), modulus.imag());
  }
  directory.write("bitumen.csv", text);
  const auto outcome = run({"bitumen.csv", "--modulus", "shear", "--law", "2s2p1d", "--keep", "static=0 Pa"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("static            0 Pa  given"));
  EXPECT_THAT(outcome.output, HasSubstr("beta              50  +- "));
  const auto* const law =
      R"(shear = { law = "2s2p1d", static = "0 Pa", glassy = "1 GPa", delta = 2.2, time = "2 ms", k = 0.22, h = 0.63, )"
      "beta = 50 }";
  EXPECT_THAT(outcome.output, HasSubstr(law));
  EXPECT_THAT(read_text(directory.path() / "results/bitumen-fit/material.toml"), HasSubstr(law));
  directory.write("deck.toml",
                  test::replaced(std::string(test::good_deck),
                                 R"(shear   = { terms = [ { time = "10 ms", modulus = "1 MPa" } ] })", law));
  const auto check = test::run_breccia(directory.path(), {"check", "deck.toml"});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  // The page and the other files are those of every fit; the series follows the law.
  EXPECT_THAT(read_text(directory.path() / "results/bitumen-fit/report.html"), HasSubstr("modulus_law"));
  const auto fit = result("results/bitumen-fit/fit.csv");
  EXPECT_LT(worst_difference(fit, "angular_frequency_rad_per_s", "fit_storage_Pa",
                             [&](double omega) {
                               return carson_modulus(RelaxationLaw(bitumen), {0.0, omega}).real();
                             }),
            1e-6);
}

TEST_F(Fit, LawOfCreepKeepsItsTime) {
  const LogarithmicCreep paste = {4e-11, 2e-11, 86400.0, 0.1};
  write_curve("creep.csv", "time_s,shear_compliance_1_per_Pa", logarithmic(1.0, 1e7, 5),
              [&](double t) { return compliance_at(CreepLaw(paste), t); });
  const auto outcome =
      run({"creep.csv", "--law", "logarithmic-creep", "--keep", "time=1 day", "--keep", "exponent=0.1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("time         86400 s  given"));
  EXPECT_LT(worst_difference(result("results/creep-fit/creep.csv"), "time_s", "shear_compliance_1_per_Pa",
                             [&](double t) { return compliance_at(CreepLaw(paste), t); }),
            2e-3);
}

// Data of DMA in tension as an instrument may export them: a deck must not take Young's modulus as a shear modulus.
TEST_F(Fit, CarriesTheKindOfTheModulus) {
  std::string text = "Instrument;DMA\n\nFrequency;E';E\";Note\nHz;MPa;MPa;\n";
  for (const double hertz : logarithmic(1e-2, 1e2, 5)) {
    const double turns = 2.0 * std::numbers::pi * hertz * tau, share = turns * turns / (1.0 + turns * turns);
    text += fmt::format("{:.9g};{:.9g};{:.9g};\n", hertz, 1e-6 * (spring + maxwell * share),
                        1e-6 * maxwell * share / turns);
  }
  std::ranges::replace(text, '.', ',');
  directory.write("dma.csv", text);
  const auto outcome = run({"dma.csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("dma.csv: Young's modulus, "));
  EXPECT_THAT(outcome.output, ::testing::ContainsRegex("frequency +E' +E''"));
  const auto series = read_text(directory.path() / "results/dma-fit/prony.csv");
  EXPECT_THAT(series, HasSubstr("# Prony series of Young's modulus. "));
  EXPECT_THAT(series, HasSubstr("\nrelaxation_time_s,youngs_modulus_Pa\n"));
  const auto dynamic = result("results/dma-fit/dynamic.csv");
  EXPECT_LT(worst_difference(dynamic, "angular_frequency_rad_per_s", "youngs_storage_modulus_Pa",
                             [](double omega) {
                               const double turns = omega * tau;
                               return spring + maxwell * turns * turns / (1.0 + turns * turns);
                             }),
            3e-3);
  directory.write("deck.toml", test::replaced(std::string(test::good_deck),
                                              R"({ terms = [ { time = "10 ms", modulus = "1 MPa" } ] })",
                                              R"({ prony = "results/dma-fit/prony.csv" })"));
  const auto check = test::run_breccia(directory.path(), {"check", "deck.toml"});
  EXPECT_EQ(check.exit_code, 2);
  EXPECT_THAT(check.errors, HasSubstr("expected a column of the shear modulus, got \"youngs_modulus_Pa\", that of "
                                      "Young's modulus: the key young takes it as it is, or convert"));
}

TEST_F(Fit, TakesTheKindOfTheModulusFromAnOption) {
  write_curve("g.csv", "time_s,modulus_Pa", logarithmic(1e-3, 1e2, 10), relaxation);
  ASSERT_EQ(run({"g.csv", "--modulus", "bulk", "--quiet"}).exit_code, 0);
  EXPECT_TRUE(result("results/g-fit/prony.csv").has("bulk_modulus_Pa"));
  const auto other = run({"g.csv", "--quiet"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.errors, HasSubstr("here is what `breccia fit` made of \"g.csv (--modulus bulk)\""));
  ASSERT_EQ(run({"g.csv", "--quiet", "--overwrite"}).exit_code, 0);
  EXPECT_TRUE(result("results/g-fit/prony.csv").has("modulus_Pa"));
  write_curve("e.csv", "time_s,tensile_modulus_Pa", logarithmic(1e-3, 1e2, 10), relaxation);
  const auto wrong = run({"e.csv", "--modulus", "shear"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(
      wrong.errors,
      HasSubstr("e.csv: expected a column of the shear modulus, got \"tensile_modulus_Pa\", that of Young's modulus"));
}

struct BadData {
  const char* text;
  const char* message;
};

TEST_F(Fit, RefusesBadFiles) {
  const std::vector<BadData> cases = {
      {"a,b\n1,2\n", "bad.csv: expected the columns of one of"},
      {"time_s,modulus_Pa,compliance_1_per_Pa\n1,2,3\n", "expected the columns of one of"},
      {"time_s,modulus_PA\n1,2\n", R"(bad.csv: the unit of "modulus_PA": expected a pressure, got "1 PA")"},
      {"time_s,compliance_Pa\n1,2\n", "expected a unit such as 1_per_Pa, got \"Pa\""},
      {"time_s,time_ms,modulus_Pa\n1,2,3\n", R"("time_ms" says the same as "time_s")"},
      {"time_s,modulus_Pa\n1,2\n2,1\n", "bad.csv: expected at least 3 rows, got 2"},
      {"time_s,modulus_Pa\n0,2\n1,-2\n2,1\n",
       "bad.csv:2: time_s: expected a positive number, got 0\n"
       "bad.csv:3: modulus_Pa: expected a positive number, got -2"},
      {"time_s,modulus_Pa\n1,x\n", "bad.csv:2: modulus_Pa: expected a number, got \"x\""},
      {"frequency_Hz,storage_modulus_Pa,loss_modulus_Pa\n1,2,3\n2,3,4\n1,2,3\n",
       "bad.csv:4: frequency_Hz: expected each frequency once at a temperature, got 1, as at bad.csv:2"},
      {"frequency_Hz,storage_modulus_Pa,loss_modulus_Pa,temperature_degC\n1,2,3,-300\n2,3,4,5\n3,4,5,6\n",
       "bad.csv:2: temperature_degC: expected a temperature above absolute zero, got -300"},
      {"frequency_Hz,storage_modulus_Pa,loss_modulus_Pa,temperature_degC\n1,2,3,0\n2,3,4,0\n1,4,5,60\n",
       "bad.csv: several temperatures: expected --reference-temperature; the sweeps are at 0 degC, 60 degC"},
      {"relaxation_time_s,modulus_Pa\n0,2\n1,-2\n",
       "bad.csv:2: expected a positive relaxation time, got 0\nbad.csv:3: expected a non-negative modulus, got -2"},
      {"relaxation_time_s,modulus_Pa\ninf,2\n", "without a term"},
      {"frequency_Hz,storage_modulus_Pa,loss_modulus_Pa,temperature_degX\n1,2,3,0\n2,3,4,0\n3,4,5,60\n",
       R"(bad.csv: the unit of "temperature_degX": expected a temperature)"},
      {"time_s,youngs_modulus_Pa,bulk_modulus_Pa\n1,2,3\n", "of several one has to be chosen"},
      {"time_s,constrained_modulus_Pa\n1,2\n", "is fitted when its column is called modulus_Pa"},
  };
  for (const auto& [text, message] : cases) {
    directory.write("bad.csv", text);
    const auto outcome = run({"bad.csv"});
    EXPECT_EQ(outcome.exit_code, 2) << message;
    EXPECT_THAT(outcome.errors, HasSubstr(message));
    EXPECT_THAT(outcome.output, ::testing::Not(HasSubstr("Results are in"))) << "at most what was understood";
  }
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "results"));
}

TEST_F(Fit, RefusesBadOptions) {
  write_curve("g.csv", "time_s,modulus_Pa", logarithmic(1e-3, 1e2, 10), relaxation);
  directory.write("maxwell.csv", "relaxation_time_s,modulus_Pa\n0.5,8e6\n");
  const auto dma = (data / "synthetic_dma.csv").string();
  const std::vector<std::pair<std::vector<std::string>, const char*>> cases = {
      {{}, "FILE is required"},
      {{"none.csv"}, "none.csv"},
      {{"g.csv", "--to", "loss"}, "--to"},
      {{"g.csv", "--modulus", "tensile"}, "--modulus"},
      {{"g.csv", "--times-per-decade", "0"}, "--times-per-decade"},
      {{"g.csv", "--ramp", "1 um"}, "--ramp: expected a time, got \"1 um\""},
      {{"g.csv", "--ramp=-1 s"}, "--ramp: expected a non-negative time, got \"-1 s\""},
      {{"g.csv", "--reference-temperature", "19 degC"}, "expected dynamic moduli at several temperatures"},
      {{"g.csv", "--law", "huet"}, "--law"},
      {{"g.csv", "--keep", "k=0.2"}, "--keep requires --law"},
      {{"g.csv", "--law", "2s2p1d", "--keep", "k"},
       "--keep: expected KEY=VALUE with one of static, glassy, delta, time, k, h, beta, got \"k\""},
      {{"g.csv", "--law", "2s2p1d", "--keep", "exponent=0.5"}, "got \"exponent=0.5\""},
      {{"g.csv", "--law", "2s2p1d", "--keep", "glassy=2 s", "--keep", "k=0.2 s"},
       "--keep glassy: expected a pressure, got \"2 s\"\n"},
      {{"g.csv", "--law", "2s2p1d", "--keep", "glassy=2 s", "--keep", "k=0.2 s"},
       "--keep k: expected a number, got \"0.2 s\""},
      {{"g.csv", "--law", "2s2p1d", "--keep", "k=0.2", "--keep", "k=0.3"}, "--keep k: given twice"},
      {{"g.csv", "--law", "2S2P1D", "--keep", "static=1 GPa"},
       "static: expected less than all data, whose smallest is"},
      {{"--law", "2s2p1d", "--keep", "glassy=1 Pa", "g.csv"}, "glassy: expected more than all data, whose largest is"},
      {{"g.csv", "--law", "2s2p1d", "--keep", "glassy=-2 GPa"}, "--keep glassy: expected a positive number"},
      {{"g.csv", "--law", "2s2p1d", "--ramp", "1 s"}, "--ramp: not with --law"},
      {{"g.csv", "--law", "2s2p1d", "--times-per-decade", "5"}, "--times-per-decade: not with --law"},
      {{"g.csv", "--law", "power-law-creep"}, "power-law-creep is a creep compliance"},
      {{"maxwell.csv", "--law", "2s2p1d"}, "--law: expected measured data, not a Prony series"},
      {{"maxwell.csv", "--ramp", "1 s"}, "--ramp: expected data against time"},
      {{dma, "--reference-temperature", "20 degC"}, "no sweep at 20 degC; the sweeps are at -41 degC, -31 degC"},
      {{dma, "--reference-temperature", "20 m"}, "--reference-temperature: expected a temperature, got \"20 m\""},
      {{dma, "--reference-temperature", "20 C"},
       R"(--reference-temperature: expected a temperature, got "20 C", did you mean "degC"?)"},
      {{dma, "--reference-temperature", "19 degC", "--ramp", "1 s"}, "--ramp: expected data against time"},
  };
  for (const auto& [arguments, message] : cases) {
    const auto outcome = run(arguments);
    EXPECT_NE(outcome.exit_code, 0) << message;
    EXPECT_THAT(outcome.errors, HasSubstr(message));
    EXPECT_THAT(outcome.output, ::testing::Not(HasSubstr("Results are in")));
  }
}

}  // namespace
}  // namespace breccia
