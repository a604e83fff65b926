// Tests of files in the forms in which instruments and spreadsheets export them (tests/reference/instrument_files.py),
// with data of a solid whose moduli are known; five of the files have mistakes.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/viscoelasticity/temperature_shift.hpp"

#include "command.hpp"
#include "deck/prony_file.hpp"
#include "temporary_directory.hpp"

namespace breccia::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::filesystem::path instruments =
    std::filesystem::path(BRECCIA_SOURCE_DIRECTORY) / "tests" / "data" / "instruments";

class Instruments : public ::testing::Test {
 protected:
  [[nodiscard]] Outcome fit(const std::string& file, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"fit", (instruments / file).string(), "--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_breccia(directory.path(), arguments);
  }
  /// Compares the fit with the known solid, or a multiple of it, at 20 degC from 0.1 to 10 Hz.
  void expect_the_solid(double factor = 1.0) const {
    const PronySeries solid(1e6, {{1e-2, 4e7}, {1.0, 8e6}, {1e2, 2e6}});
    const auto file = read_prony_file(directory.path() / "out" / "prony.csv");
    const PronySeries fitted(file.equilibrium.value_or(0.0), file.terms);
    for (double frequency = 0.1; frequency < 10.1; frequency *= 1.3) {
      const double omega = 2.0 * std::numbers::pi * frequency;
      const auto expected = factor * solid.complex_modulus(omega);
      EXPECT_LT(std::abs(fitted.complex_modulus(omega) - expected) / std::abs(expected), 0.01) << frequency << " Hz";
    }
  }

  TemporaryDirectory directory;
};

TEST_F(Instruments, ARheometerWithUnitsInARowOfTheirOwn) {
  const auto outcome = fit("rheometer.csv", {"--reference-temperature", "20 degC"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("27 rows, UTF-8, commas between columns, names in line 7, units below"));
  EXPECT_THAT(outcome.output, HasSubstr("storage modulus (shear)    \"Storage modulus G'\" [MPa], "));
  EXPECT_THAT(outcome.output, HasSubstr("temperature                \"Temperature\" [°C], 10 to 30"));
  EXPECT_THAT(outcome.output,
              HasSubstr("not read                   \"Tan(delta)\", \"Oscillation torque\", \"Step time\""));
  EXPECT_LT(outcome.output.find("not read"), outcome.output.find("deviation from the data"));
  expect_the_solid();
}

TEST_F(Instruments, AnAnalyserWithItsNamesInAComment) {
  const auto outcome = fit("tension.csv", {"--reference-temperature", "20 degC"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("Latin-1, decimal commas, semicolons between columns, names in line 4"));
  EXPECT_THAT(outcome.output, HasSubstr("storage modulus (Young's)"));
  EXPECT_THAT(outcome.output, HasSubstr("WLF: c1 = "));
  expect_the_solid(3.0);
}

TEST_F(Instruments, Utf16WithColumnsThatTheUserNames) {
  const auto outcome = fit("unicode.txt", {"--columns", "storage=M'", "--columns", "loss=M''", "--columns",
                                           "temperature=Ts", "--modulus", "shear"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("UTF-16, tabs between columns, names in line 3, units below"));
  EXPECT_THAT(outcome.output, HasSubstr("storage modulus            \"M'\" [MPa]"));
  expect_the_solid();
}

TEST_F(Instruments, AngularFrequenciesAndExponents) {
  const auto outcome = fit("sweeps.txt", {"--reference-temperature", "20 degC"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("\"Angular Frequency\" [rad/s]"));
  expect_the_solid();
}

TEST_F(Instruments, NamesInAnotherLanguage) {
  const auto without = fit("german.csv");
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_THAT(without.errors, HasSubstr("it has \"Frequenz [Hz]\", \"Speichermodul [MPa]\""));
  EXPECT_THAT(
      without.errors,
      testing::EndsWith("\n--columns tells which column is which, as in --columns storage=NAME --columns loss=NAME\n"));
  const auto outcome = fit("german.csv", {"--columns", "frequency=Frequenz [Hz]", "--columns",
                                          "storage=Speichermodul [MPa]", "--columns", "loss=Verlustmodul [MPa]"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("UTF-8, decimal commas, semicolons"));
  expect_the_solid();
}

TEST_F(Instruments, AnAbsoluteValueAndAPhaseAngle) {
  const auto outcome = fit("asphalt.csv", {"--reference-temperature", "20 degC"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("absolute modulus (shear)   \"|G*| (kPa)\" [kPa], "));
  EXPECT_THAT(outcome.output, HasSubstr("phase angle                \"Phase angle (°)\" [°], "));
  EXPECT_THAT(outcome.output, HasSubstr(" K at 20 degC meet both factors, as some law does for any two"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("+- 0")));
  expect_the_solid();
}

TEST_F(Instruments, AStorageModulusAndALossFactor) {
  const auto outcome = fit("bending.csv");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("loss tangent               \"Tan Delta\""));
  EXPECT_THAT(outcome.output, HasSubstr("\"Temperature\" [°F], 68 to 68"));
  EXPECT_THAT(outcome.output, HasSubstr("not read                   \"Stiffness\""));
  expect_the_solid(3.0);
}

TEST_F(Instruments, AnAbsoluteValueAndAPhaseAngleThatTheUserNames) {
  const auto outcome = fit("asphalt.csv", {"--reference-temperature", "20 degC", "--columns", "absolute=|G*| (kPa)",
                                           "--columns", "phase=Phase angle (°)"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  expect_the_solid();
}

TEST_F(Instruments, ATableForEachTemperature) {
  const auto outcome = fit("steps.csv", {"--reference-temperature", "20 degC"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("27 rows of 3 tables, UTF-8, commas between columns, names in line 5"));
  EXPECT_THAT(outcome.output, HasSubstr("3 sweeps at temperatures from 10 degC to 30 degC"));
  EXPECT_THAT(outcome.output, HasSubstr("The file does not say which modulus it has: it is taken for G"));
  expect_the_solid();
}

TEST_F(Instruments, ColumnsAlignedByBlanks) {
  const auto outcome = fit("aligned.txt", {"--reference-temperature", "20 degC"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("blanks between columns, names in line 4, units below"));
  expect_the_solid();
}

TEST_F(Instruments, ARampOfTheTemperature) {
  const auto outcome = fit("ramp.csv", {"--reference-temperature", "20 degC"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("the temperature changes through the measurement: moduli interpolated to 35 "
                                        "temperatures from 6 degC to 40 degC"));
  EXPECT_THAT(outcome.output, HasSubstr("WLF: c1 = "));
  expect_the_solid();
  directory.write("one.csv", "Temperature [degC],Frequency [Hz],G' [MPa],G'' [MPa]\n10,1,9,1\n12,1,8,1\n14,1,7,1\n");
  const auto one = run_breccia(directory.path(), {"fit", "one.csv", "--reference-temperature", "12 degC"});
  EXPECT_EQ(one.exit_code, 2);
  EXPECT_THAT(one.errors, HasSubstr("the temperature changes through the measurement, so two frequencies are needed"));
}

/// A temperature [degC] and a frequency [Hz] of a measurement.
struct Condition {
  double celsius, frequency;
};

/// A file of moduli of the known solid.
std::string file_of(const std::vector<Condition>& conditions) {
  std::string text = "Temperature [degC],Frequency [Hz],G' [MPa],G'' [MPa]\n";
  const PronySeries solid(1e6, {{1e-2, 4e7}, {1.0, 8e6}, {1e2, 2e6}});
  const WilliamsLandelFerry law{10.0, 100.0, 293.15};
  for (const auto& [celsius, frequency] : conditions) {
    const double omega = 2.0 * std::numbers::pi * frequency * law.shift_factor(celsius + 273.15);
    const auto modulus = solid.complex_modulus(omega);
    text += fmt::format("{},{},{},{}\n", celsius, frequency, modulus.real() / 1e6, modulus.imag() / 1e6);
  }
  return text;
}

/// A file of moduli of the known solid at 0.3, 3 and 30 Hz in turn, which may scatter, at given temperatures.
std::string ramp_through(const std::vector<double>& temperatures, double scatter = 0.0) {
  std::vector<Condition> conditions;
  for (const double celsius : temperatures) {
    const auto i = conditions.size();
    const double noise = 1.0 + scatter * std::sin(7.0 * static_cast<double>(i));
    conditions.push_back({celsius, std::array{0.3, 3.0, 30.0}.at(i % 3) * noise});
  }
  return file_of(conditions);
}

TEST_F(Instruments, RampsThatFallOrAreUneven) {
  std::vector<double> falling, uneven;
  for (int i = 0; i <= 120; ++i) falling.push_back(41.0 - 0.3 * i);
  double at = 5.0;
  for (int i = 0; at < 41.0; ++i) {
    uneven.push_back(at);
    at += std::array{0.4, 0.7, 0.2, 0.6}.at(static_cast<std::size_t>(i) % 4);
  }
  directory.write("falling.csv", ramp_through(falling));
  directory.write("uneven.csv", ramp_through(uneven, 0.003));
  for (const auto* file : {"falling.csv", "uneven.csv"}) {
    const auto outcome = run_breccia(
        directory.path(), {"fit", file, "--reference-temperature", "20 degC", "--out", "out", "--overwrite"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("the temperature changes through the measurement")) << file;
    expect_the_solid();
  }
  auto both = falling;
  both.insert(both.end(), falling.rbegin(), falling.rend());
  directory.write("both.csv", ramp_through(both));
  EXPECT_THAT(run_breccia(directory.path(), {"fit", "both.csv"}).errors,
              HasSubstr("both.csv: the temperature rises and falls: keep the rows of one direction"));
}

// One sweep of five drifts by 2.4 K: no sweep is interpolated.
TEST_F(Instruments, ASweepThatDriftsIsNoRamp) {
  std::vector<Condition> conditions;
  for (int sweep = 0; sweep < 5; ++sweep) {
    for (int i = 0; i < 7; ++i) {
      conditions.push_back({10.0 * sweep + (sweep == 0 ? 0.4 * i : 0.0), std::pow(10.0, i / 3.0 - 1.0)});
    }
  }
  directory.write("drift.csv", file_of(conditions));
  const auto outcome = run_breccia(directory.path(), {"fit", "drift.csv", "--reference-temperature", "20 degC"});
  EXPECT_THAT(outcome.output, HasSubstr("5 sweeps at temperatures from 1.2 degC to 40 degC")) << outcome.errors;
}

TEST_F(Instruments, TablesOfRelaxationAreNotOneCurve) {
  directory.write("two.csv", "time_s,modulus_Pa\n1,3\n2,2\n3,1\ntime_s,modulus_Pa\n1,6\n2,5\n");
  const auto outcome = run_breccia(directory.path(), {"fit", "two.csv"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("two.csv: 2 tables, one below the other: only dynamic moduli with a column of "
                                        "temperatures may have several; keep one of them"));
}

TEST_F(Instruments, WorkbooksOfTwoLibraries) {
  const auto beside = fit("openpyxl.xlsx", {"--reference-temperature", "20 degC"});
  ASSERT_EQ(beside.exit_code, 0) << beside.errors;
  EXPECT_THAT(beside.output, HasSubstr("openpyxl.xlsx: 27 rows, sheet \"Sweeps\", names in row 3, units below\n"));
  EXPECT_THAT(beside.output, HasSubstr("not read                   \"Remark\""));
  expect_the_solid();
  const auto first = fit("xlsxwriter.xlsx", {"--reference-temperature", "20 degC", "--overwrite"});
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_THAT(first.output, HasSubstr("xlsxwriter.xlsx: 27 rows, sheet \"DMA\", names in row 1\n"));
  EXPECT_THAT(first.output, HasSubstr("storage modulus (shear)    \"G' [Pa]\" [Pa], "));
  EXPECT_THAT(first.output, HasSubstr("not read                   \"Measured on\""));
  expect_the_solid();
}

TEST_F(Instruments, FilesThatAreNotSoundAreRefusedWithWhatIsWrong) {
  struct Broken {
    const char* file;
    std::vector<const char*> messages;
  };
  const std::vector<Broken> files = {
      {"broken-thousands.csv", {"the comma of \"1,234\" may be a decimal one or part thousands"}},
      {"broken-phase.csv",
       {":3: Phase angle [deg]: expected an angle above 0 and below 90 degrees, got 93.2",
        ":4: Phase angle [deg]: expected an angle above 0 and below 90 degrees, got 0"}},
      {"broken-values.csv",
       {":2: Loss modulus [MPa]: expected a number, got \"overload\"", ":3: Loss modulus [MPa]: expected a number",
        ":5: expected 3 values"}},
      {"broken-signs.csv",
       {":2: Loss modulus [MPa]: expected a positive number, got -0.1",
        ":4: Storage modulus [MPa]: expected a positive number, got 0"}},
      {"broken-workbook.csv", {"broken-workbook.csv: a damaged archive ("}},
  };
  for (const auto& [file, messages] : files) {
    const auto outcome = fit(file);
    EXPECT_EQ(outcome.exit_code, 2) << file;
    for (const auto* message : messages) EXPECT_THAT(outcome.errors, HasSubstr(message));
    EXPECT_EQ(outcome.output, "") << file;
    EXPECT_FALSE(std::filesystem::exists(directory.path() / "out"));
  }
}

TEST_F(Instruments, ColumnsThatAreNotThereAreReportedTogether) {
  const auto missing = fit("rheometer.csv", {"--columns", "storage=E1", "--columns", "loss=E2"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.errors, HasSubstr("no column \"E1\"; it has \"Storage modulus G'\""));
  EXPECT_THAT(missing.errors, HasSubstr("no column \"E2\""));
  const auto words = fit(
      "rheometer.csv", {"--columns", "storrage=x", "--columns", "loss", "--columns", "time=a", "--columns", "time=b"});
  EXPECT_EQ(words.exit_code, 2);
  EXPECT_THAT(words.errors, HasSubstr("--columns: unknown quantity \"storrage\", did you mean \"storage\"?"));
  EXPECT_THAT(words.errors, HasSubstr("expected QUANTITY=NAME"));
  EXPECT_THAT(words.errors, HasSubstr("--columns: time is given twice"));
}

}  // namespace
}  // namespace breccia::test
