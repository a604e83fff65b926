#include "measured.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "breccia/error.hpp"
#include "breccia/tables/measured_table_reader.hpp"
#include "breccia/tables/modulus_kind.hpp"

#include "deck/column_words.hpp"
#include "deck/fit_data.hpp"
#include "views.hpp"
#include "words.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

constexpr std::array plain_quantities = {
    std::pair("time", Quantity::time), std::pair("temperature", Quantity::temperature),
    std::pair("angular_frequency", Quantity::angular_frequency), std::pair("phase_angle", Quantity::phase_angle),
    std::pair("loss_tangent", Quantity::loss_tangent)};

/// The quantities that have a kind of modulus.
constexpr std::array quantities_of_kinds = {
    std::pair("modulus", Quantity::modulus), std::pair("compliance", Quantity::compliance),
    std::pair("storage_modulus", Quantity::storage_modulus), std::pair("loss_modulus", Quantity::loss_modulus),
    std::pair("absolute_modulus", Quantity::absolute_modulus)};

/// Columns by the words for their quantities.
using Columns = std::vector<std::pair<std::string, std::string>>;

MeasuredTable table_in(const std::filesystem::path& file, const Columns& columns) {
  std::vector<NamedColumn> named;
  for (const auto& [word, name] : columns) named.push_back({word, name});
  return read_measured_table(file, column_choices(named, "columns"));
}

ModulusKind kind_named(const std::string& word) {
  const auto kind = kind_of_word(word);
  if (kind && *kind != ModulusKind::other) return *kind;
  throw InputError(fmt::format(R"(kind: expected "shear", "young" or "bulk", got "{}")", word));
}

py::dict read(const std::filesystem::path& file, const py::object& kind, const Columns& chosen) {
  const auto table = table_in(file, chosen);
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
py::list sweeps_in(const std::filesystem::path& file, const py::object& kind, const Columns& columns) {
  const auto given = kind.is_none() ? ModulusKind::unspecified : kind_named(kind.cast<std::string>());
  const auto input = fit_data_in(table_in(file, columns), given);
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
  module.def("read_sweeps", &sweeps_in, py::arg("file"), py::arg("kind"), py::arg("columns"));
  module.def("read_measured", &read, py::arg("file"), py::arg("kind"), py::arg("columns"));
}

}  // namespace breccia::python
