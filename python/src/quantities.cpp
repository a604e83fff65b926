#include "quantities.hpp"

#include <array>
#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "arguments.hpp"
#include "io/units.hpp"

namespace breccia::python {
namespace {

/// The dimension with this name ("length").
Dimension dimension_named(const std::string& wanted) {
  constexpr std::array all = {
      Dimension::length,    Dimension::time,    Dimension::frequency,    Dimension::temperature_difference,
      Dimension::pressure,  Dimension::density, Dimension::temperature,  Dimension::inverse_length,
      Dimension::area,      Dimension::angle,   Dimension::molar_energy, Dimension::interface_stiffness,
      Dimension::compliance};
  for (const auto dimension : all) {
    if (name(dimension) == wanted) return dimension;
  }
  throw InputError(fmt::format("dimension: unknown \"{}\"", wanted));
}

}  // namespace

void bind_quantities(pybind11::module_& module) {
  module.def(
      "quantity",
      [](const pybind11::object& text, const std::string& dimension) {
        if (pybind11::isinstance<pybind11::str>(text)) {
          return parse_quantity(text.cast<std::string>(), dimension_named(dimension));
        }
        throw InputError(fmt::format("text: expected a number with its unit in quotes, got {}",
                                     pybind11::repr(text).cast<std::string>()));
      },
      pybind11::arg("text"), pybind11::arg("dimension"),
      R"(The SI value of a number with its unit: quantity("0.5 um", "length") is 5e-07 [m].)");
  module.def("refuse_what_numpy_drops", &refuse_what_numpy_drops, pybind11::arg("argument"), pybind11::arg("expected"),
             pybind11::arg("value"),
             "InputError for numbers with a unit of another package, or with an imaginary part.");
}

}  // namespace breccia::python
