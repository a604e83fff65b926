#include "io/units.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

struct Accepted {
  const char* text;
  Dimension dimension;
  double si;
};

TEST(Units, ConvertToSi) {
  const std::vector<Accepted> cases{
      {"48 um", Dimension::length, 48e-6},
      {"48um", Dimension::length, 48e-6},
      {"0.5 µm", Dimension::length, 0.5e-6},
      {" 2.75  mm ", Dimension::length, 2.75e-3},
      {"1 inch", Dimension::length, 0.0254},
      {"10 ns", Dimension::time, 10e-9},
      {"1e-3 s", Dimension::time, 1e-3},
      {"2 h", Dimension::time, 7200.0},
      {"5 kHz", Dimension::frequency, 5000.0},
      {"40e-6 /MPa", Dimension::compliance, 40e-12},
      {"40 1/TPa", Dimension::compliance, 40e-12},
      {"10 megahertz", Dimension::frequency, 1e7},
      {"10 rad/s", Dimension::frequency, 1.591549430918953},
      {"10 rad s-1", Dimension::frequency, 1.591549430918953},
      {"720 degree/s", Dimension::frequency, 2.0},
      {"60 rpm", Dimension::frequency, 1.0},
      {"3 cycle/s", Dimension::frequency, 3.0},
      {"120 revolution/min", Dimension::frequency, 2.0},
      {"3.6 GPa", Dimension::pressure, 3.6e9},
      {"+1 kN/mm^2", Dimension::pressure, 1e9},
      {"1 psi", Dimension::pressure, 6894.757293168},
      {"1.48 g/cm^3", Dimension::density, 1480.0},
      {"1850 kg m-3", Dimension::density, 1850.0},
      {"19 degC", Dimension::temperature, 292.15},
      {"-40 degF", Dimension::temperature, 233.15},
      {"292.15 K", Dimension::temperature, 292.15},
      {"120 K", Dimension::temperature_difference, 120.0},
      {"120 degC", Dimension::temperature_difference, 120.0},
      {"9 degF", Dimension::temperature_difference, 5.0},
      {"12500 /mm", Dimension::inverse_length, 1.25e7},
      {"66 1/mm", Dimension::inverse_length, 6.6e4},
      {"66 mm^-1", Dimension::inverse_length, 6.6e4},
  };
  for (const auto& [text, dimension, si] : cases) {
    EXPECT_NEAR(parse_quantity(text, dimension), si, 1e-12 * std::abs(si)) << text;
  }
}

struct Refused {
  const char* text;
  Dimension dimension;
  const char* message;
};

TEST(Units, RefuseWhatIsNotAQuantityOfTheDimension) {
  const std::vector<Refused> cases{
      {"3.6 um", Dimension::pressure, "expected a pressure, got \"3.6 um\""},
      {"30", Dimension::angle, R"(expected an angle with its unit, such as "30 deg", got "30")"},
      {"30 mm", Dimension::angle, "expected an angle, got \"30 mm\""},
      {"10 Hz", Dimension::time, "expected a time, got \"10 Hz\""},
      {"10 s", Dimension::frequency, "expected a frequency, got \"10 s\""},
      {"10 1/s", Dimension::frequency,
       "expected a frequency, got \"10 1/s\": it may mean cycles or radians, 1 Hz is 6.2832 rad/s; expected Hz or "
       "rad/s"},
      {"10 Bq", Dimension::frequency,
       "expected a frequency, got \"10 Bq\": it may mean cycles or radians, 1 Hz is 6.2832 rad/s; expected Hz or "
       "rad/s"},
      {"10 rad", Dimension::frequency, "expected a frequency, got \"10 rad\""},
      {"120 m", Dimension::temperature, "expected a temperature, got \"120 m\""},
      {"3.6 Gpa", Dimension::pressure,
       R"(expected a pressure, got "3.6 Gpa": unknown unit "Gpa", did you mean "GPa"?)"},
      {"3.6 GPPa", Dimension::pressure,
       R"(expected a pressure, got "3.6 GPPa": unknown unit "GPPa", did you mean "GPa"?)"},
      {"3.6 foo", Dimension::pressure, R"(expected a pressure, got "3.6 foo": unknown unit "foo")"},
      {"10 S", Dimension::time, R"(expected a time, got "10 S", did you mean "s"?)"},
      {"20 C", Dimension::temperature, R"(expected a temperature, got "20 C", did you mean "degC"?)"},
      {"5 F", Dimension::temperature_difference,
       R"(expected a temperature difference, got "5 F", did you mean "degF"?)"},
      {"3.6", Dimension::pressure, R"(expected a pressure with its unit, such as "3.6 GPa", got "3.6")"},
      {"GPa", Dimension::pressure, R"(expected a pressure, a number and its unit such as "3.6 GPa", got "GPa")"},
      {"", Dimension::length, R"(expected a length, a number and its unit such as "48 um", got "")"},
      {"3 10 um", Dimension::length, R"(expected a length, a number and its unit such as "48 um", got "3 10 um")"},
      {"inf s", Dimension::time, R"(expected a time, a number and its unit such as "10 ns", got "inf s")"},
      {"nan s", Dimension::time, R"(expected a time, a number and its unit such as "10 ns", got "nan s")"},
      {"12,5 um", Dimension::length, R"(expected a length, got "12,5 um": expected a decimal point, got a comma)"},
      {"1e400 um", Dimension::length, R"(expected a length, a number and its unit such as "48 um", got "1e400 um")"},
  };
  for (const auto& refused : cases) {
    const auto message =
        test::message_of<InputError>([&] { static_cast<void>(parse_quantity(refused.text, refused.dimension)); });
    EXPECT_EQ(message, refused.message);
  }
}

TEST(Units, AnglesAreInRadians) {
  EXPECT_EQ(parse_quantity("180 deg", Dimension::angle), std::numbers::pi);
  EXPECT_EQ(parse_quantity("90 degree", Dimension::angle), 0.5 * std::numbers::pi);
  EXPECT_EQ(parse_quantity("-0.5 rad", Dimension::angle), -0.5);
  EXPECT_EQ(readable(std::numbers::pi / 6.0, Dimension::angle), "30 deg");
}

TEST(Units, NumbersInOtherUnits) {
  const auto quantity = split_quantity(" -40 degC");
  ASSERT_TRUE(quantity);
  EXPECT_EQ(quantity->number, -40.0);
  EXPECT_EQ(quantity->unit, "degC");
  EXPECT_EQ(number_in_unit(*quantity, "degC"), -40.0);
  EXPECT_DOUBLE_EQ(number_in_unit(*quantity, "K").value(), 233.15);
  EXPECT_NEAR(number_in_unit(*quantity, "degF").value(), -40.0, 1e-12);
  EXPECT_EQ(number_in_unit({1.0, "mm"}, "um"), 1000.0);
  EXPECT_EQ(number_in_unit({6.0, "points"}, "points"), 6.0);
  EXPECT_FALSE(number_in_unit({6.0, "points"}, "um"));
  EXPECT_FALSE(number_in_unit({1.0, "s"}, "um"));
  EXPECT_FALSE(split_quantity("um"));
}

TEST(Units, ReadableQuantitiesHaveUnitsThatSuitTheirSize) {
  EXPECT_EQ(readable(48e-6, Dimension::length), "48 um");
  EXPECT_EQ(readable(1e-3, Dimension::length), "1 mm");
  EXPECT_EQ(readable(1.5e7, Dimension::time), "1.5e+07 s");
  EXPECT_EQ(readable(5.84e9, Dimension::pressure), "5.84 GPa");
  EXPECT_EQ(readable(0.0, Dimension::pressure), "0 Pa");
  EXPECT_EQ(readable(1480.0, Dimension::density), "1480 kg/m^3");
}

TEST(Units, ReadableQuantitiesReadBack) {
  for (const double length : {1e-10, 3.3e-8, 4.8e-5, 0.002, 7.0, 1234.0}) {
    EXPECT_NEAR(parse_quantity(readable(length, Dimension::length), Dimension::length), length, 1e-5 * length);
  }
}

}  // namespace
}  // namespace breccia
