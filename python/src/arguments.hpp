#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>

#include "io/range.hpp"
#include "io/units.hpp"

namespace breccia::python {

/// Numbers of a caller; a copy only where they are not doubles already.
using Numbers = pybind11::array_t<double, pybind11::array::forcecast>;

/// The expected range and unit of the numbers of an argument.
struct Expected {
  std::string_view argument;
  std::string_view unit;  ///< unit; empty for a number without a unit
  Range range;
};

/// Throws InputError, which is a ValueError, for a number out of its range: "time: expected a non-negative number in
/// s, got -1".
void require(const Expected& expected, double value);

/// Throws InputError for a number or an array of which NumPy would drop a part without a word: a unit of another
/// package, or an imaginary part. `expected` is what a caller may write instead, "a number in s".
void refuse_what_numpy_drops(std::string_view argument, std::string_view expected, const pybind11::handle& value);

/// A number of a caller, or text with a unit of a dimension, in the SI unit. Throws InputError for anything else.
double quantity_of(std::string_view argument, const pybind11::handle& value, Dimension dimension);

/// An angular frequency [rad/s]: a number, or text such as "10 rad/s" or "1 Hz". Throws InputError for anything else.
double angular_frequency_of(std::string_view argument, const pybind11::handle& value);

/// The numbers of an argument: one, an array, or text that `in_si` reads. Throws InputError for anything else, and
/// where a number is out of its range.
Numbers numbers_of(const Expected& expected, const pybind11::object& values,
                   double (*in_si)(std::string_view argument, const pybind11::handle& value));

/// A time as text with a unit, in [s]; for numbers_of().
double time_of(std::string_view argument, const pybind11::handle& value);

/// The pairs of an argument: an n x 2 array, or any iterable of pairs, each of a time, as a number [s] or text with a
/// unit, and of a value that `second` reads. Throws InputError, with the `expected` form, for anything else; also for a
/// tuple of two lists and for two lists of two numbers, which may be meant as two columns.
std::vector<std::pair<double, double>> pairs_of(std::string_view argument, std::string_view expected,
                                                const pybind11::object& pairs,
                                                double (*second)(std::string_view argument,
                                                                 const pybind11::handle& value));

/// A modulus [Pa], and a number without a unit; for pairs_of().
double modulus_of(std::string_view argument, const pybind11::handle& value);
double plain_number_of(std::string_view argument, const pybind11::handle& value);

}  // namespace breccia::python
