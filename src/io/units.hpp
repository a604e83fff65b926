#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breccia {

/// The dimension of a quantity, with the SI unit of its values.
enum class Dimension {
  length,                  ///< [m]
  time,                    ///< [s]
  frequency,               ///< [1/s]
  pressure,                ///< [Pa]
  density,                 ///< [kg/m^3]
  temperature,             ///< [K]; "19 degC" is 292.15 K
  temperature_difference,  ///< [K]; "120 degC" is 120 K
  inverse_length,          ///< [1/m]
  area,                    ///< [m^2]
  angle,                   ///< [rad]
  molar_energy,            ///< [J/mol]
  interface_stiffness,     ///< [Pa/m]
  compliance,              ///< [1/Pa]
  expansion                ///< [1/K]
};

/// The dimension as a noun: "length", "pressure".
std::string_view name(Dimension dimension);

/// The name of a dimension with its article: "a length", "an angle".
std::string with_article(Dimension dimension);

/// The SI unit of a dimension, as parse_quantity() reads it: "Pa".
std::string_view si_unit(Dimension dimension);

/// An example of a quantity for messages: "48 um".
std::string_view example(Dimension dimension);

/// The SI value of a number with its unit, such as "3.6 GPa". The units are those of UDUNITS-2; "/mm" stands for
/// "1/mm". Throws InputError when the text is not a finite quantity of the dimension: `expected a pressure, got
/// "3.6 um"`.
double parse_quantity(std::string_view text, Dimension dimension);

/// The number and the unit of a quantity such as "3.6 GPa".
struct NumberAndUnit {
  double number;
  std::string unit;  ///< unit; empty if there is none
};

/// Splits a text into number and unit. Returns nothing when it has no finite number or a second number follows
/// ("3 10 um").
std::optional<NumberAndUnit> split_quantity(std::string_view text);

/// The number of the quantity in another unit: "1 mm" is 1000 in "um". Returns nothing when the units have different
/// dimensions, or when they are unknown and differ.
std::optional<double> number_in_unit(const NumberAndUnit& quantity, const std::string& unit);

/// Whether a unit of a frequency certainly counts cycles, as kHz and megahertz do.
bool is_in_hertz(std::string_view unit);

/// An SI value as text with a unit that fits its size: "48 um". It has 6 digits, and parse_quantity() can read it.
std::string readable(double value, Dimension dimension);

}  // namespace breccia
