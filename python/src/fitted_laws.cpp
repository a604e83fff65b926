#include "fitted_laws.hpp"

#include <cmath>

#include <pybind11/stl.h>

namespace breccia::python {

namespace py = pybind11;

py::object table_of(const std::optional<FittedLaw>& law) {
  if (!law) return py::none();
  py::dict table;
  table["law"] = name_of(law->form);
  for (const auto& parameter : law->parameters) {
    // Without a dashpot a deck has no `beta`.
    if (std::isfinite(parameter.value)) table[py::str(std::string(parameter.key))] = parameter.value;
  }
  return table;
}

py::object errors_of(const std::optional<FittedLaw>& law) {
  if (!law) return py::none();
  py::dict errors;
  for (const auto& parameter : law->parameters) {
    const bool is_left_out = parameter.origin == ParameterOrigin::limit;
    errors[py::str(std::string(parameter.key))] =
        is_left_out ? py::object(py::none()) : py::float_(parameter.standard_error);
  }
  return errors;
}

py::object state_of(const std::optional<FittedLaw>& law) {
  if (!law) return py::none();
  py::list parameters;
  for (const auto& [key, value, error, origin] : law->parameters) {
    parameters.append(py::make_tuple(value, error, static_cast<int>(origin)));
  }
  return py::make_tuple(name_of(law->form), parameters);
}

std::optional<FittedLaw> fitted_law_from(const py::object& state) {
  if (state.is_none()) return std::nullopt;
  const auto parts = state.cast<py::tuple>();
  FittedLaw law = {.form = value_named<LawForm>(parts[0].cast<std::string>()).value()};
  auto known = parameters_of(law.form).begin();
  for (const auto& one : parts[1]) {
    const auto numbers = one.cast<py::tuple>();
    law.parameters.push_back({.key = (known++)->key,
                              .value = numbers[0].cast<double>(),
                              .standard_error = numbers[1].cast<double>(),
                              .origin = static_cast<ParameterOrigin>(numbers[2].cast<int>())});
  }
  return law;
}

}  // namespace breccia::python
