#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace breccia {

/// A number with an SI prefix: value = number * scale, where the scale is a power of 1000.
struct PrefixedNumber {
  double number;            ///< 1 <= |number| < 1000 where a prefix exists
  std::string_view prefix;  ///< "f" to "T", "u" for micro, "" for none
  double scale;             ///< value of the prefix, 1e-15 to 1e12
};

/// The number with the engineering prefix that fits it when it is shown with this many significant digits (1 to 15):
/// 999.96e-6 is 1 m(illi) to three digits. Zero, infinities and numbers beyond the range of the prefixes get none.
PrefixedNumber with_prefix(double value, int digits = 3);

/// A quantity as text, for example "48 um" or "3.6 GPa".
/// The unit of the value must be one that can have a prefix ("m", "s", "Pa").
std::string display(double value, std::string_view unit, int digits = 3);

/// A value of an input in its SI unit, or without one: "5.84 GPa", "293 K", "0.31".
std::string number_in_words(double value, std::string_view unit, int digits = 3);

/// A number rounded to three digits, in the shortest form: "1000", "0.0123", "1e+06".
std::string three_digits(double value);

/// A time [s] in a test as text, without kilo- and larger prefixes: "10 ms", "1000 s", "2.5e6 s".
std::string display_time(double seconds, int digits = 3);

/// The duration [s] of a calculation as text: "800 ms", "50 min", "3 h".
std::string display_duration(double seconds, int digits = 2);

/// A number as text with this many significant digits, or with more where it would look equal to another number: 2.998
/// beside 3, not 3.
std::string display_beside(double value, double other, int digits = 2);

/// A positive number rounded down, or up, to two significant digits. A number that has two digits apart from rounding
/// errors does not change.
double rounded_down_to_two_digits(double value);
double rounded_up_to_two_digits(double value);

/// A count with its noun as text: "1 term", "12 terms".
std::string display_count(std::size_t count, std::string_view noun);

}  // namespace breccia
