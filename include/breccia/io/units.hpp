#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breccia {

/// What a quantity measures. Its value is in the SI unit given here.
enum class Dimension {
  length,                  ///< [m]
  time,                    ///< [s]
  frequency,               ///< [1/s]
  pressure,                ///< [Pa]
  density,                 ///< [kg/m^3]
  temperature,             ///< [K]; "19 degC" is 292.15 K
  temperature_difference,  ///< [K]; "120 degC" is 120 K
  inverse_length           ///< [1/m]
};

/// The dimension as a noun: "length", "pressure".
std::string_view name(Dimension dimension);

/// A quantity of the dimension, as a user would write it: "48 um".
std::string_view example(Dimension dimension);

/// The SI value of a number with its unit, such as "3.6 GPa". Units are those of UDUNITS-2; "/mm" is short for "1/mm".
/// Throws InputError when the text is not a finite quantity of the dimension: `expected a pressure, got "3.6 um"`.
double parse_quantity(std::string_view text, Dimension dimension);

/// A number and what stands behind it: "3.6 GPa" in two.
struct NumberAndUnit {
  double number;
  std::string unit;  ///< empty without one
};

/// Cuts a text in two. Nothing without a finite number, or when a second number follows it (as in "3 10 um").
std::optional<NumberAndUnit> split_quantity(std::string_view text);

/// The number of the same quantity in another unit: 1 of "1 mm" in "um" is 1000. Nothing when the units have different
/// dimensions, or are not known and not the same text.
std::optional<double> number_in_unit(const NumberAndUnit& quantity, const std::string& unit);

/// An SI value for people, with a unit that suits its size: "48 um". parse_quantity reads it back, rounded to 6 digits.
std::string readable(double value, Dimension dimension);

}  // namespace breccia
