#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace breccia {

/// A quantity split for people to read: value = number * 10^(3 k), the power of ten as an SI prefix.
struct PrefixedNumber {
  double number;            ///< 1 <= |number| < 1000 where a prefix exists
  std::string_view prefix;  ///< "f" to "T", "u" for micro, "" for none
  double scale;             ///< what the prefix stands for, 1e-15 to 1e12
};

/// The number with the engineering prefix that suits it when shown with this many significant digits (1 to 15):
/// 999.96e-6 is 1 m(illi) to three digits. Zero, infinities and what lies beyond the prefixes get none.
PrefixedNumber with_prefix(double value, int digits = 3);

/// A quantity as text, for example "48 um" or "3.6 GPa".
/// The value is in the unit, which must be one that takes a prefix ("m", "s", "Pa").
std::string display(double value, std::string_view unit, int digits = 3);

/// A time [s] at which something happens in a test: "10 ms", "1000 s", "2.5e6 s". Nobody speaks of kiloseconds.
std::string display_time(double seconds, int digits = 3);

/// A time [s] that a calculation takes: "800 ms", "50 min", "3 h".
std::string display_duration(double seconds, int digits = 2);

/// "1 term", "12 terms".
std::string display_count(std::size_t count, std::string_view noun);

}  // namespace breccia
