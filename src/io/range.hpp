#pragma once

#include <limits>
#include <string>
#include <string_view>

#include "io/units.hpp"

namespace breccia {

/// A range of accepted numbers: finite ones between two limits.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool excludes_lower = false;
  bool excludes_upper = false;

  static constexpr Range positive() { return {.lower = 0.0, .excludes_lower = true}; }
  static constexpr Range not_negative() { return {.lower = 0.0}; }
  static constexpr Range at_least(double lower) { return {.lower = lower}; }
  static constexpr Range between(double lower, double upper) { return {lower, upper, true, true}; }
  static constexpr Range above_and_up_to(double lower, double upper) { return {lower, upper, true, false}; }
};

/// Whether a value is finite and within a range.
bool accepts(const Range& range, double value);

/// The description of the numbers in a range: "a positive integer", "a number between 0 and 1".
std::string described(const Range& range, std::string_view noun);
/// The description of the quantities in a range of the SI unit: "a length from 1 pm to 1000 km".
std::string described(const Range& range, Dimension dimension);

}  // namespace breccia
