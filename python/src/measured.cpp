#include "measured.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl/filesystem.h>

#include "breccia/deck/fit_data.hpp"
#include "breccia/error.hpp"
#include "breccia/io/measured_table_reader.hpp"
#include "breccia/io/modulus_kind.hpp"

#include "views.hpp"
#include "words.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

constexpr std::array plain_quantities = {std::pair("time", Quantity::time),
                                         std::pair("temperature", Quantity::temperature),
                                         std::pair("angular_frequency", Quantity::angular_frequency)};

/// Those that are of a kind of modulus.
constexpr std::array quantities_of_kinds = {
    std::pair("modulus", Quantity::modulus), std::pair("compliance", Quantity::compliance),
    std::pair("storage_modulus", Quantity::storage_modulus), std::pair("loss_modulus", Quantity::loss_modulus)};

ModulusKind kind_named(const std::string& word) {
  const auto kind = kind_of_word(word);
  if (kind && *kind != ModulusKind::other) return *kind;
  throw InputError(fmt::format(R"(kind: expected "shear", "young" or "bulk", got "{}")", word));
}

py::dict read(const std::filesystem::path& file, const py::object& kind) {
  const auto table = read_measured_table(file);
  const auto wanted = kind.is_none() ? ModulusKind::unspecified : kind_named(kind.cast<std::string>());
  py::dict columns;
  for (const auto& [key, quantity] : plain_quantities) {
    if (table.has({quantity})) columns[key] = array_of(table.column(quantity).values);
  }
  for (const auto& [key, quantity] : quantities_of_kinds) {
    if (table.has({quantity})) columns[key] = array_of(table.column(quantity, wanted).values);
  }
  return columns;
}

/// The frequency sweeps in a file as tuples of temperature, angular frequencies, storage and loss moduli.
py::list sweeps_in(const std::filesystem::path& file, const py::object& kind) {
  const auto given = kind.is_none() ? ModulusKind::unspecified : kind_named(kind.cast<std::string>());
  const auto input = fit_data_in(read_measured_table(file), given);
  const auto* const data = std::get_if<DynamicData>(&input.data);
  if (data == nullptr) {
    throw InputError(fmt::format("{}: expected storage and loss moduli against the frequency", file.string()));
  }
  py::list sweeps;
  for (const auto& [temperature, frequencies, storage, loss] : data->sweeps) {
    sweeps.append(py::make_tuple(temperature, array_of(frequencies), array_of(storage), array_of(loss)));
  }
  return sweeps;
}

}  // namespace

void bind_measured(py::module_& module) {
  module.def("read_sweeps", &sweeps_in, py::arg("file"), py::arg("kind"));
  module.def(
      "read_measured", &read, py::arg("file"), py::arg("kind") = py::none(),
      "The columns of a table of measured data that are known by their names, in SI units, whatever those of the "
      "file: time [s], temperature [K], angular_frequency [rad/s], modulus, storage_modulus, loss_modulus [Pa], "
      "compliance [1/Pa].\n\n"
      "kind: \"shear\", \"young\" or \"bulk\": refuses columns of another kind.");
}

}  // namespace breccia::python
