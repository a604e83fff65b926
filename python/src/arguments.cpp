#include "arguments.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

std::string shown(const py::handle& value) {
  return py::repr(value).cast<std::string>();
}

std::optional<double> number_in(const py::handle& value) {
  try {
    return value.cast<double>();
  } catch (const py::cast_error&) {
    return std::nullopt;
  }
}

/// Whether these are two lists or arrays in a tuple, which many users write for two columns but none for pairs, or two
/// arrays or two lists of two numbers without units in a list, which may be either.
bool may_be_columns(const py::object& pairs) {
  const auto is_text = [](const py::handle& value) { return py::isinstance<py::str>(value); };
  const bool is_tuple = py::isinstance<py::tuple>(pairs);
  if ((!is_tuple && !py::isinstance<py::list>(pairs)) || py::len(pairs) != 2) return false;
  for (const auto& one : pairs) {
    if (py::isinstance<py::tuple>(one) || !py::isinstance<py::iterable>(one)) return false;
    if (is_tuple || py::hasattr(one, "dtype")) continue;
    if (!py::isinstance<py::list>(one) || py::len(one) != 2 || std::any_of(one.begin(), one.end(), is_text))
      return false;
  }
  return true;
}

[[noreturn]] void refuse_pairs(std::string_view argument, std::string_view expected, const std::string& got) {
  throw InputError(fmt::format("{}: expected {}, got {}; zip() makes pairs of two lists", argument, expected, got));
}

}  // namespace

void require(const Expected& expected, double value) {
  if (accepts(expected.range, value)) return;
  const auto unit = expected.unit.empty() ? std::string() : fmt::format(" in {}", expected.unit);
  throw InputError(
      fmt::format("{}: expected {}{}, got {}", expected.argument, described(expected.range, "number"), unit, value));
}

void refuse_what_numpy_drops(std::string_view argument, std::string_view expected, const py::handle& value) {
  const auto refuse = [&](std::string_view what) {
    throw InputError(fmt::format("{}: expected {}, got {}: {}", argument, expected, what, shown(value)));
  };
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    for (const auto& element : value) refuse_what_numpy_drops(argument, expected, element);
    return;
  }
  if (py::hasattr(value, "units") || py::hasattr(value, "unit")) refuse("a quantity of another package");
  if (PyComplex_Check(value.ptr()) != 0) refuse("a complex number");
  if (!py::hasattr(value, "dtype")) return;
  const auto kind = py::str(value.attr("dtype").attr("kind")).cast<std::string>();
  if (kind == "c") refuse("complex numbers");
  if (kind == "m" || kind == "M") refuse("a time of numpy, whose unit would be lost");
}

double quantity_of(std::string_view argument, const py::handle& value, Dimension dimension) {
  if (py::isinstance<py::str>(value)) {
    try {
      return parse_quantity(value.cast<std::string>(), dimension);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", argument, error.what()));
    }
  }
  const auto expected = fmt::format("{}, as a number or as text with a unit", with_article(dimension));
  refuse_what_numpy_drops(argument, expected, value);
  if (const auto number = number_in(value)) return *number;
  throw InputError(fmt::format("{}: expected {}, got {}", argument, expected, shown(value)));
}

double angular_frequency_of(std::string_view argument, const py::handle& value) {
  if (!py::isinstance<py::str>(value)) return quantity_of(argument, value, Dimension::frequency);
  const auto quantity = split_quantity(value.cast<std::string>());
  if (quantity && quantity->unit.find("rad") != std::string::npos) {
    if (const auto number = number_in_unit(*quantity, "rad/s")) return *number;
  }
  return 2.0 * std::numbers::pi * quantity_of(argument, value, Dimension::frequency);
}

double time_of(std::string_view argument, const py::handle& value) {
  return quantity_of(argument, value, Dimension::time);
}

double modulus_of(std::string_view argument, const py::handle& value) {
  return quantity_of(argument, value, Dimension::pressure);
}

double plain_number_of(std::string_view argument, const py::handle& value) {
  refuse_what_numpy_drops(argument, "a number", value);
  if (const auto number = number_in(value)) return *number;
  throw InputError(fmt::format("{}: expected a number, got {}", argument, shown(value)));
}

Numbers numbers_of(const Expected& expected, const py::object& values,
                   double (*in_si)(std::string_view argument, const py::handle& value)) {
  const bool is_text = py::isinstance<py::str>(values);
  if (!is_text) refuse_what_numpy_drops(expected.argument, fmt::format("numbers in {}", expected.unit), values);
  auto numbers = Numbers::ensure(is_text ? py::float_(in_si(expected.argument, values)) : values);
  if (!numbers) {
    PyErr_Clear();
    throw InputError(
        fmt::format("{}: expected numbers in {}, got {}", expected.argument, expected.unit, shown(values)));
  }
  const py::array_t<double, py::array::c_style | py::array::forcecast> contiguous(numbers);
  for (py::ssize_t i = 0; i < contiguous.size(); ++i) require(expected, contiguous.data()[i]);
  return numbers;
}

std::vector<std::pair<double, double>> pairs_of(std::string_view argument, std::string_view expected,
                                                const py::object& pairs,
                                                double (*second)(std::string_view argument, const py::handle& value)) {
  if (!py::isinstance<py::iterable>(pairs)) refuse_pairs(argument, expected, shown(pairs));
  if (may_be_columns(pairs)) {
    const auto* const lists =
        py::isinstance<py::tuple>(pairs) ? "a tuple of two lists" : "two lists that may be columns";
    refuse_pairs(argument, expected, fmt::format("{}, {}", lists, shown(pairs)));
  }
  std::vector<std::pair<double, double>> read;
  for (const auto& pair : pairs) {
    const bool has_two = py::isinstance<py::sequence>(pair) && !py::isinstance<py::str>(pair) && py::len(pair) == 2;
    if (!has_two) refuse_pairs(argument, expected, fmt::format("{} in place of a pair", shown(pair)));
    const auto one = py::reinterpret_borrow<py::sequence>(pair);
    read.emplace_back(time_of(argument, py::object(one[0])), second(argument, py::object(one[1])));
  }
  return read;
}

}  // namespace breccia::python
