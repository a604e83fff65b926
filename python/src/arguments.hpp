#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include "breccia/error.hpp"
#include "breccia/io/range.hpp"

namespace breccia::python {

/// What is expected of the numbers of an argument.
struct Expected {
  std::string_view argument;
  std::string_view unit;  ///< empty for a number without one
  Range range;
};

/// Throws InputError, which is a ValueError, for a number out of its range: "time: expected a non-negative number in
/// s, got -1".
inline void require(const Expected& expected, double value) {
  if (accepts(expected.range, value)) return;
  const auto unit = expected.unit.empty() ? std::string() : fmt::format(" in {}", expected.unit);
  throw InputError(
      fmt::format("{}: expected {}{}, got {}", expected.argument, described(expected.range, "number"), unit, value));
}

/// The same for each number of an array.
inline void require_each(
    const Expected& expected,
    const pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>& values) {
  for (pybind11::ssize_t i = 0; i < values.size(); ++i) require(expected, values.data()[i]);
}

}  // namespace breccia::python
