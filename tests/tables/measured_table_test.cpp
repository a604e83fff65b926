#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/tables/measured_table_reader.hpp"

#include "messages.hpp"
#include "tables/complex_modulus.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using enum Quantity;
using testing::ElementsAre;
using testing::HasSubstr;

class MeasuredTableTest : public testing::Test {
 protected:
  [[nodiscard]] MeasuredTable read(std::string_view text) const {
    return read_measured_table(directory.written("table.csv", text));
  }
  template <class Use>
  [[nodiscard]] std::string mistakes(std::string_view text, const Use& use) const {
    const auto message = test::message_of<InputError>([&] { use(read(text)); });
    return test::replaced(message, directory.path().string() + "/", "");
  }
  [[nodiscard]] std::string mistakes(std::string_view text) const {
    return mistakes(text, [](const MeasuredTable&) {});
  }

  test::TemporaryDirectory directory;
};

/// A name of a column, and 3 in its unit.
struct Known {
  const char* name;
  Quantity quantity;
  double three;
  ModulusKind kind = ModulusKind::unspecified;
};

TEST_F(MeasuredTableTest, RecognisesColumnsByTheirNames) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const std::vector<Known> cases{
      {"time_s", time, 3.0},
      {"time_ms", time, 3e-3},
      {"Time [min]", time, 180.0},
      {"t / s", time, 3.0},
      {"relaxation_time_us", relaxation_time, 3e-6},
      {"tau (s)", relaxation_time, 3.0},
      {"frequency_Hz", angular_frequency, turn * 3.0},
      {"Freq. (kHz)", angular_frequency, turn * 3e3},
      {"omega (krad/s)", angular_frequency, 3e3},
      {"angular_frequency_krad_per_min", angular_frequency, 50.0},
      {"omega [mrad/s]", angular_frequency, 3e-3},
      {"Frequency [rad/s]", angular_frequency, 3.0},
      {"angular_frequency_rad_per_ms", angular_frequency, 3e3},
      {"omega/(rad/s)", angular_frequency, 3.0},
      {"f [megahertz]", angular_frequency, turn * 3e6},
      {"frequency_rpm", angular_frequency, turn * 0.05},
      {"frequency [cycles/s]", angular_frequency, turn * 3.0},
      {"ω [s⁻¹]", angular_frequency, 3.0},
      {"Storage modulus (E')/MPa", storage_modulus, 3e6, ModulusKind::young},
      {"Complex modulus (G*) [dyn/cm^2]", absolute_modulus, 0.3, ModulusKind::shear},
      {"omega [rpm]", angular_frequency, turn * 0.05},
      {"ω [1/s]", angular_frequency, 3.0},
      {"temperature_K", temperature, 3.0},
      {"Temp (°C)", temperature, 276.15},
      {"T [C]", temperature, 276.15},
      {"temp_degF", temperature, 257.0388888888889},
      {"modulus_Pa", modulus, 3.0},
      {"shear_modulus_MPa", modulus, 3e6, ModulusKind::shear},
      {"Relaxation modulus [GPa]", modulus, 3e9},
      {"youngs_modulus_Pa", modulus, 3.0, ModulusKind::young},
      {"Young's modulus / kPa", modulus, 3e3, ModulusKind::young},
      {"tensile_relaxation_modulus_MPa", modulus, 3e6, ModulusKind::young},
      {"E(t) [MPa]", modulus, 3e6, ModulusKind::young},
      {"K_GPa", modulus, 3e9, ModulusKind::bulk},
      {"oedometric modulus [MPa]", modulus, 3e6, ModulusKind::other},
      {"compliance_1_per_GPa", compliance, 3e-9},
      {"J(t) [1/MPa]", compliance, 3e-6, ModulusKind::shear},
      {"Tensile compliance [Pa^-1]", compliance, 3.0, ModulusKind::young},
      {"storage_modulus_MPa", storage_modulus, 3e6},
      {"Storage modulus G' [Pa]", storage_modulus, 3.0, ModulusKind::shear},
      {"shear_storage_modulus_Pa", storage_modulus, 3.0, ModulusKind::shear},
      {"E′ (MPa)", storage_modulus, 3e6, ModulusKind::young},
      {"loss [kPa]", loss_modulus, 3e3},
      {"G\" [Pa]", loss_modulus, 3.0, ModulusKind::shear},
      {"tensile_loss_modulus_MPa", loss_modulus, 3e6, ModulusKind::young},
      {"|G*| [MPa]", absolute_modulus, 3e6, ModulusKind::shear},
      {"E* (kPa)", absolute_modulus, 3e3, ModulusKind::young},
      {"Complex modulus [Pa]", absolute_modulus, 3.0},
      {"Complex Shear Modulus / MPa", absolute_modulus, 3e6, ModulusKind::shear},
      {"Dynamic modulus |E*| (MPa)", absolute_modulus, 3e6, ModulusKind::young},
      {"phase_angle_deg", phase_angle, 3.0 * std::numbers::pi / 180.0},
      {"Phase angle δ [°]", phase_angle, 3.0 * std::numbers::pi / 180.0},
      {"Phase Shift Angle [mrad]", phase_angle, 3e-3},
      {"delta (rad)", phase_angle, 3.0},
      {"tan_delta", loss_tangent, 3.0},
      {"Tan(delta)", loss_tangent, 3.0},
      {"tan(δ) [-]", loss_tangent, 3.0},
      {"Loss factor tan(δ) [1]", loss_tangent, 3.0},
      {"shear_loss_tangent", loss_tangent, 3.0, ModulusKind::shear},
      {"diameter_um", diameter, 3e-6},
      {"x [mm]", x, 3e-3},
      {"y_m", y, 3.0},
      {"cumulative_volume_fraction", cumulative_volume_fraction, 3.0},
      {"cumulative volume fraction [%]", cumulative_volume_fraction, 0.03},
      {"Shift factor", shift_factor, 3.0},
      {"a_T", shift_factor, 3.0},
      {"aT [-]", shift_factor, 3.0},
      {"log10_shift_factor", log10_shift_factor, 3.0},
      {"log aT", log10_shift_factor, 3.0},
      {"log10(a_T)", log10_shift_factor, 3.0},
  };
  for (const auto& [name, quantity, three, kind] : cases) {
    // A complex modulus takes two columns.
    const bool is_angle = quantity == phase_angle || quantity == loss_tangent;
    const auto table = read(fmt::format("{},something,{}\n3,else,1\n", name,
                                        quantity == absolute_modulus ? "phase_angle_rad"
                                        : is_angle                   ? "loss_modulus_Pa"
                                                                     : "other"));
    ASSERT_TRUE(table.has({quantity})) << name;
    EXPECT_DOUBLE_EQ(table.column(quantity).values.at(0), three) << name;
    EXPECT_EQ(table.column(quantity).written.at(0), 3.0) << name;
    EXPECT_EQ(table.column(quantity).kind, kind) << name;
  }
}

TEST_F(MeasuredTableTest, OtherUnitsGiveTheSameBits) {
  const auto table = read("x_um,y_nm,diameter_mm,time_ms,compliance_1_per_MPa\n7,7,0.3,0.7,1.1\n");
  EXPECT_EQ(table.column(x).values.at(0), 7e-6);
  EXPECT_EQ(table.column(y).values.at(0), 7e-9);
  EXPECT_EQ(table.column(diameter).values.at(0), 0.3e-3);
  EXPECT_EQ(table.column(time).values.at(0), 0.7e-3);
  EXPECT_EQ(table.column(compliance).values.at(0), 1.1e-6);
}

TEST_F(MeasuredTableTest, OtherColumnsMayHoldAnything) {
  const auto table = read(
      "time_stamp,time_s,,temperature_setpoint_degC,Note,Note,modulus_Pa,log_modulus_Pa\n"
      "12:01,1,,-,\"a, b\",c,2,x\n");
  EXPECT_THAT(table.column(time).values, ElementsAre(1.0));
  EXPECT_THAT(table.column(modulus).values, ElementsAre(2.0));
  EXPECT_FALSE(table.has({temperature}));
}

// |M*| = 5, tan(delta) = 3 / 4: M' = 4, M'' = 3.
TEST_F(MeasuredTableTest, TwoColumnsDetermineAComplexModulus) {
  for (const auto* text : {
           "storage_modulus_Pa,loss_modulus_Pa\n4,3\n",
           "storage_modulus_Pa,phase_angle_rad\n4,0.6435011087932844\n",
           "storage_modulus_Pa,tan_delta\n4,0.75\n",
           "loss_modulus_Pa,phase_angle_rad\n3,0.6435011087932844\n",
           "loss_modulus_Pa,tan_delta\n3,0.75\n",
           "|G*| [Pa],phase_angle_deg\n5,36.86989764584402\n",
           "tan_delta,G* [Pa]\n0.75,5\n",
       }) {
    const auto table = read(text);
    const auto columns = complex_modulus_columns(table);
    ASSERT_TRUE(columns.has_value()) << text;
    const auto modulus = complex_modulus(table, *columns, ModulusKind::unspecified);
    EXPECT_NEAR(modulus.storage.at(0), 4.0, 1e-14) << text;
    EXPECT_NEAR(modulus.loss.at(0), 3.0, 1e-14) << text;
  }
  EXPECT_FALSE(complex_modulus_columns(read("storage_modulus_Pa,|G*| [Pa]\n4,5\n")).has_value());
}

TEST_F(MeasuredTableTest, WhatFollowsFromTwoColumnsMayHoldAnything) {
  EXPECT_TRUE(read("time_s,modulus_Pa,tan_delta,phase_angle_deg\n1,2,-,overload\n").has({modulus}));
  const auto table = read("loss_modulus_Pa,tan_delta,|G*| [Pa],storage_modulus_Pa,phase_angle_deg\n3,-,overload,4,\n");
  EXPECT_TRUE(table.has({storage_modulus, loss_modulus}));
  EXPECT_FALSE(table.has({loss_tangent}) || table.has({absolute_modulus}) || table.has({phase_angle}));
  const std::vector<ColumnChoice> choices = {{absolute_modulus, "B [Pa]"}, {phase_angle, "A [deg]"}};
  const auto path = directory.written("chosen.csv", "storage_modulus_Pa,loss_modulus_Pa,B [Pa],A [deg]\n-,-,5,30\n");
  const auto chosen = read_measured_table(path, choices);
  EXPECT_TRUE(chosen.has({absolute_modulus, phase_angle}));
  EXPECT_FALSE(chosen.has({storage_modulus}) || chosen.has({loss_modulus}));
}

TEST_F(MeasuredTableTest, AnUnknownUnitIsAnErrorOnlyInTheSoleColumnOfAQuantity) {
  const auto* text = "time_stamp,modulus_PA\n1,2\n";
  EXPECT_EQ(mistakes(text,
                     [](const MeasuredTable& table) {
                       table.require({time, modulus});
                     }),
            "table.csv: the unit of \"time_stamp\": expected a time, got \"1 stamp\": unknown unit \"stamp\"\n"
            "table.csv: the unit of \"modulus_PA\": expected a pressure, got \"1 PA\", did you mean \"Pa\"?");
  EXPECT_EQ(mistakes("time,modulus_Pa\n1,2\n",
                     [](const MeasuredTable& table) {
                       table.require({time, modulus});
                     }),
            "table.csv: the unit of \"time\": expected one in the name of the column, as in \"[s]\", got none");
  EXPECT_EQ(mistakes("a,modulus_Pa\n1,2\n", [](const MeasuredTable& table) { table.require({time}); }),
            "table.csv: no column of times, such as time_s; it has \"a\", \"modulus_Pa\"");
}

TEST_F(MeasuredTableTest, FillersAreKnownBesideDiametersAlone) {
  EXPECT_THAT(read("x_um,y_um,diameter_um,filler\n1,2,3,1\n4,5,6,0\n").column(filler).values, ElementsAre(1.0, 0.0));
  EXPECT_FALSE(read("time_s,modulus_Pa,filler\n1,2,glass\n4,5,steel\n").has({filler}));
}

TEST_F(MeasuredTableTest, SeparatorsAndDecimalSigns) {
  for (const auto* text : {
           "time_s,modulus_Pa\n1.5,2\n2.5,1e3\n",
           "time_s;modulus_Pa\n1,5;2\n2,5;1e3\n",
           "time_s\tmodulus_Pa\n1,5\t2\n2,5\t1e3\n",
           "time_s;modulus_Pa\r\n1.5;2\r\n2.5;1e3\r\n;\r\n",
           "\"Time [s]\";\"Modulus [Pa]\";\n1,5;2;\n2,5;1e3;\n",
           "\xEF\xBB\xBFTime;Modulus\ns;Pa\n1,5;2\n2,5;1e3\n",
           "Time,Modulus\n[s],(Pa)\n1.5,2\n2.5,1e3\n",
           "Instrument;DHR-3\nOperator;Doe, J.\n\n[Data]\nTime [s];Modulus [Pa]\n1,5;2\n2,5;1e3\n",
       }) {
    const auto table = read(text);
    EXPECT_THAT(table.column(time).values, ElementsAre(1.5, 2.5)) << text;
    EXPECT_THAT(table.column(modulus).values, ElementsAre(2.0, 1000.0)) << text;
  }
}

// In a table with 1.5 the comma of 1,234 separates thousands: the number is not 1.234.
TEST_F(MeasuredTableTest, BothDecimalSignsAreRefused) {
  EXPECT_EQ(mistakes("time_s;modulus_Pa\n1.5;1,234\n"),
            "table.csv:2: modulus_Pa: expected a number, got \"1,234\" (other numbers have decimal points)");
}

TEST_F(MeasuredTableTest, CommasThatMaySeparateThousandsAreRefused) {
  EXPECT_EQ(mistakes("time_s;modulus_Pa\n1;2,000\n2;1,500\n"),
            "table.csv: the comma of \"2,000\" may be a decimal one or part thousands; write points, or no commas in "
            "thousands");
  EXPECT_THAT(read("time_s;modulus_Pa\n1;2,000\n2;0,125\n").column(modulus).values, ElementsAre(2.0, 0.125));
  for (const auto* number : {"-2,000", "+2,000", "2,000e5", "-2,000E-03", "1,234,567", "12,345"}) {
    EXPECT_THAT(mistakes(fmt::format("time_s;modulus_Pa\n1;{}\n", number)),
                HasSubstr(fmt::format("the comma of \"{}\" may be", number)));
  }
  EXPECT_THAT(read("time_s;modulus_Pa\n1;-1,25e1\n2;1,5E-1\n").column(modulus).values, ElementsAre(-12.5, 0.15));
}

TEST_F(MeasuredTableTest, IgnoresCommasInColumnsThatAreNotRead) {
  // 0,5 and 3.25 are in columns without known names.
  EXPECT_THAT(mistakes("time_s;modulus_Pa;note\n1;2,000;0,5\n"), HasSubstr("the comma of \"2,000\" may be"));
  const auto table = read("time_s;modulus_Pa;note;remark\n1,5;2;3.25;e,E\n2,5;3;1,000;-,-\n");
  EXPECT_THAT(table.column(time).values, ElementsAre(1.5, 2.5));
  EXPECT_THAT(read("time_s;modulus_Pa;note\n1;2000;1,000\n").column(modulus).values, ElementsAre(2000.0));
}

TEST_F(MeasuredTableTest, AFrequencyIsInHertzOrRadians) {
  const auto use = [](const MeasuredTable& table) { table.require({angular_frequency}); };
  for (const auto* unit : {"1/s", "s-1", "1/ms", "1/min", "1/sec", "/s", "s**-1", "1/hour"}) {
    EXPECT_THAT(mistakes(fmt::format("frequency [{}],modulus_Pa\n1,2\n", unit), use),
                HasSubstr(fmt::format("\"{}\" may mean cycles or radians; write Hz or rad/s", unit)));
  }
  for (const auto* unit : {"1/ms", "Hz", "1/min"}) {
    EXPECT_THAT(mistakes(fmt::format("omega [{}],modulus_Pa\n1,2\n", unit), use),
                HasSubstr(fmt::format("expected a unit such as rad_per_s, got \"{}\"", unit)));
  }
}

TEST_F(MeasuredTableTest, Latin1) {
  const auto table = read(
      "Temp [\xb0"
      "C];Frequency [Hz]\n20;1\n");
  EXPECT_DOUBLE_EQ(table.column(temperature).values.at(0), 293.15);
}

TEST_F(MeasuredTableTest, OneMessageInThePlaceOfAFlood) {
  EXPECT_EQ(mistakes("time_s modulus_Pa\n1 2\n2 3\n"),
            "table.csv:1: expected columns, separated by commas, semicolons or tabs, got \"time_s modulus_Pa\"");
  EXPECT_EQ(mistakes("time_s,modulus_Pa\n1,5,2,5\n"),
            "table.csv:2: expected 2 values (time_s, modulus_Pa), got 4 (with decimal commas, separate the columns by "
            "semicolons)");
  EXPECT_EQ(mistakes("1,2\n3,4\n"),
            "table.csv:1: expected the name of a column (the first line is the header), got \"1\"\n"
            "table.csv:1: expected the name of a column (the first line is the header), got \"2\"");
  EXPECT_EQ(mistakes("# nothing\n"), "table.csv: expected a header line");
}

TEST_F(MeasuredTableTest, TwoColumnsOfOneQuantityAreOneIfTheyAgree) {
  const auto table = read("omega [rad/s],Frequency [Hz],time_s,time_ms\n6.28319,1,1,1000\n12.566,2,2,2000\n");
  EXPECT_THAT(table.column(angular_frequency).values, ElementsAre(6.28319, 12.566));
  EXPECT_THAT(table.column(time).values, ElementsAre(1.0, 2.0));
  EXPECT_EQ(table.columns().size(), 2);
  EXPECT_EQ(
      mistakes("time_s,time_ms\n1,2\n"),
      "table.csv: \"time_ms\" says the same as \"time_s\", with other values; leave one of them out, or choose one");
}

TEST_F(MeasuredTableTest, ColumnsPartedByBlanks) {
  const auto table = read(
      "Curve Name:\n  binder\n   Index       t   Temp. \n             [s]    [°C]\n  0      1.5   20\n  1   2.5      "
      "30  \n");
  EXPECT_THAT(table.column(time).values, ElementsAre(1.5, 2.5));
  EXPECT_THAT(table.column(temperature).values, ElementsAre(293.15, 303.15));
}

TEST_F(MeasuredTableTest, TablesBelowOneAnother) {
  const auto* table = "Test\nStep,1\nTime,Modulus\ns,Pa\n1,3\n2,2\n\n[step]\nStep,2\nTime,Modulus\ns,Pa\n3,1\n";
  EXPECT_THAT(read(table).column(time).values, ElementsAre(1.0, 2.0, 3.0));
  EXPECT_EQ(read(table).reading().tables, 2);
  EXPECT_EQ(read(table).location(2).substr(read(table).location(2).rfind(':')), ":12");
  // A row that is cut off, or has no number, does not count as a line between two tables.
  EXPECT_EQ(mistakes("Time,Modulus,Note\ns,Pa,\n1,3\nTime,Modulus,Note\ns,Pa,\n3,1,a\n"),
            "table.csv:3: expected 3 values (Time, Modulus, Note), got 2");
  EXPECT_EQ(mistakes("Time,Modulus\ns,Pa\n1,overload\nTime,Modulus\ns,Pa\n3,1\n"),
            "table.csv:3: Modulus: expected a number, got \"overload\"");
  // Tables with other units or other columns are refused.
  EXPECT_EQ(mistakes("Time,Modulus\ns,Pa\n1,3\nTime,Modulus\ns,kPa\n3,1\nTime,Modulus\ns,Pa\n4,1\n"),
            "table.csv:5: expected the units of the first table, as it has the same names");
  EXPECT_EQ(mistakes("Time [s],Modulus [Pa]\n1,3\nModulus [Pa],Time [s]\n3,1\nTime [s],Modulus [Pa]\n4,1\n"),
            "table.csv:3: another table begins here, with other columns: keep one of them in the file");
  EXPECT_EQ(read("  i      t    Temp.\n         s    °C\n 1   1.5   20\n  i      t    Temp.\n         s    °C\n 1   "
                 "2.5   30\n")
                .reading()
                .tables,
            2);
}

TEST_F(MeasuredTableTest, NumbersWithSignsThatPartThousands) {
  for (const auto* number : {"1.234.567,5", "1 234,5", "1'234.5", "\"1,234,567.5\""}) {
    EXPECT_THAT(mistakes(fmt::format("time_s;modulus_Pa\n1;{}\n", number)),
                HasSubstr("(numbers are read without signs that part thousands)"))
        << number;
  }
  EXPECT_THAT(mistakes("time_s,modulus_Pa\n1,\"0,5\"\n"),
              HasSubstr("(decimal commas are read where semicolons or tabs part the columns)"));
}

// Where no name is known, the message lists the texts above the numbers as the names.
TEST_F(MeasuredTableTest, NamesInAnotherLanguageAreThoseAboveTheNumbers) {
  const auto table = read("Projekt:\tBinder\nDaten:\t1\t8\nNr.\tFrequenz\tSpeichermodul\n\t[Hz]\t[Pa]\n1\t0,5\t3\n");
  EXPECT_THAT(table.names(), ElementsAre("Nr.", "Frequenz", "Speichermodul"));
}

TEST_F(MeasuredTableTest, AChoiceNeedsNoUnit) {
  const auto path =
      directory.written("chosen.csv", "Frequenz [Hz];Speichermodul E' [MPa];Kreisfrequenz [rad/s]\n1;2;3\n");
  const auto table = read_measured_table(
      path, std::vector<ColumnChoice>{{angular_frequency, "Kreisfrequenz"}, {storage_modulus, "Speichermodul E'"}});
  EXPECT_EQ(table.column(angular_frequency).values.at(0), 3.0);
  EXPECT_EQ(table.column(storage_modulus, ModulusKind::young).values.at(0), 2e6);
  EXPECT_EQ(table.column(storage_modulus).kind, ModulusKind::young);
}

TEST_F(MeasuredTableTest, TheTimeOfDynamicModuliMayHaveAnyContent) {
  const auto table = read("Time,frequency_Hz,storage_modulus_Pa,loss_modulus_Pa\n09:30:12,1,2,3\n09:31:12,2,3,3\n");
  EXPECT_FALSE(table.has({time}));
  EXPECT_THAT(table.column(storage_modulus).values, ElementsAre(2.0, 3.0));
  EXPECT_THAT(mistakes("time_s,modulus_Pa\n09:30:12,2\n"), HasSubstr("time_s: expected a number"));
}

TEST_F(MeasuredTableTest, TheKindOfAModulusIsNotMistaken) {
  const auto of_kind = [](ModulusKind kind) {
    return [kind](const MeasuredTable& table) { static_cast<void>(table.column(modulus, kind)); };
  };
  const auto* young = "time_s,youngs_modulus_Pa\n1,2\n";
  EXPECT_EQ(mistakes(young, of_kind(ModulusKind::shear)),
            "table.csv: expected a column of the shear modulus, got \"youngs_modulus_Pa\", that of Young's modulus: "
            "the key young takes it as it is, or convert it by "
            "G = E / (2 (1 + nu)), nu being Poisson's ratio, and begin the name of the column with shear_");
  EXPECT_THAT(mistakes(young, of_kind(ModulusKind::bulk)), HasSubstr("K = E / (3 (1 - 2 nu))"));
  for (const auto* name :
       {"tensile_modulus_Pa", "elastic_modulus_MPa", "bulk_modulus_Pa", "E [GPa]", "constrained_modulus_Pa"}) {
    EXPECT_THAT(mistakes(std::string("time_s,") + name + "\n1,2\n", of_kind(ModulusKind::shear)),
                HasSubstr("expected a column of the shear modulus, got"))
        << name;
  }
  EXPECT_THAT(mistakes("time_s,shear_modulus_Pa\n1,2\n", of_kind(ModulusKind::bulk)),
              HasSubstr("expected a column of the bulk modulus, got \"shear_modulus_Pa\""));
  const auto both = read("time_s,youngs_modulus_Pa,shear_modulus_Pa\n1,3,1\n");
  EXPECT_EQ(both.column(modulus, ModulusKind::shear).values.at(0), 1.0);
  EXPECT_THAT(both.kinds(), ElementsAre(ModulusKind::young, ModulusKind::shear));
  EXPECT_EQ(read("time_s,modulus_Pa\n1,2\n").column(modulus, ModulusKind::shear).values.at(0), 2.0);
}

}  // namespace
}  // namespace breccia
