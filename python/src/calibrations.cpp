#include "calibrations.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "breccia/error.hpp"
#include "breccia/tables/modulus_kind.hpp"

#include "deck/asked_calibration.hpp"
#include "following.hpp"
#include "solution.hpp"
#include "views.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

using Composites = std::vector<std::pair<std::string, std::shared_ptr<Solution>>>;
using Data = std::vector<std::pair<std::size_t, std::filesystem::path>>;

Responder responder_of_solution(const std::string& name, const Solution& solution) {
  if (!solution.responses.empty()) return Responder(solution.responses, solution.content.materials);
  throw InputError(fmt::format(
      "{}: this result has no reduced responses, which the quasi-static method with the reduced solver leaves", name));
}

py::dict dict_of(const Estimate& estimate) {
  py::dict entries;
  entries["name"] = estimate.name;
  entries["unit"] = estimate.unit;
  entries["value"] = estimate.value;
  entries["interval"] = std::pair(estimate.interval.lower, estimate.interval.upper);
  const double half_width = normal_score(0.975);
  entries["before"] =
      std::pair(value_at_score(estimate.prior, -half_width), value_at_score(estimate.prior, half_width));
  entries["learned"] = estimate.learned;
  return entries;
}

/// The measurements and their predictions as columns.
py::dict columns_of(const std::vector<std::string>& names, const std::vector<Observation>& observations,
                    const Calibration& found) {
  std::vector<std::string> composites, moduli, curves;
  std::vector<double> at, measured, predicted, lower, upper, deviations;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const auto& observation = observations[i];
    const auto& prediction = found.predictions[i];
    composites.push_back(names[observation.composite]);
    moduli.emplace_back(name_of(observation.modulus));
    curves.emplace_back(name_of(observation.curve));
    at.push_back(observation.at);
    measured.push_back(observation.value);
    predicted.push_back(prediction.value);
    lower.push_back(prediction.interval.lower);
    upper.push_back(prediction.interval.upper);
    deviations.push_back(prediction.deviation);
  }
  py::dict columns;
  columns["composite"] = composites;
  columns["modulus"] = moduli;
  columns["curve"] = curves;
  columns["at"] = array_of(at);
  columns["measured"] = array_of(measured);
  columns["predicted"] = array_of(predicted);
  columns["lower"] = array_of(lower);
  columns["upper"] = array_of(upper);
  columns["deviation"] = array_of(deviations);
  return columns;
}

py::dict calibrate_with(const Composites& composites, const Data& data, std::vector<std::string> unknowns,
                        const std::optional<std::string>& modulus, const std::optional<std::string>& stage,
                        std::optional<double> noise, std::optional<double> model_error, int samples) {
  AskedCalibration asked;
  for (const auto& [name, solution] : composites) {
    asked.composites.emplace_back(name, responder_of_solution(name, *solution));
  }
  for (const auto& [composite, file] : data) asked.measured.data.push_back({composite, file});
  asked.unknowns = std::move(unknowns);
  asked.measured.modulus = modulus_named(modulus);
  asked.stage = stage.value_or("");
  asked.measured.noise = noise;
  asked.model_error = model_error;
  asked.samples = samples;
  const auto found = calculate([&asked] { return calibrate(asked); });
  std::vector<std::string> names;
  for (const auto& composite : found.composites) names.push_back(composite.name);
  return calibration_entries(names, found.observations, found.result, found.notes);
}

}  // namespace

ModulusKind modulus_named(const std::optional<std::string>& word) {
  if (!word) return ModulusKind::unspecified;
  const auto kind = kind_of_word(*word);
  if (kind && *kind != ModulusKind::other) return *kind;
  throw InputError(fmt::format(R"(modulus: expected "shear", "young" or "bulk", got "{}")", *word));
}

py::dict calibration_entries(const std::vector<std::string>& composites, const std::vector<Observation>& observations,
                             const Calibration& found, const std::vector<std::string>& notes) {
  py::list estimates;
  for (const auto& estimate : found.estimates) estimates.append(dict_of(estimate));
  py::dict entries;
  entries["estimates"] = estimates;
  entries["correlation"] = found.correlation;
  entries["predictions"] = columns_of(composites, observations, found);
  py::dict materials;
  for (const auto& material : found.materials) materials[py::str(material.material.name)] = material.material;
  entries["materials"] = materials;
  entries["noise"] = found.noise * observations.front().deviation;
  entries["independent_samples"] = found.independent_samples;
  auto warnings = found.warnings;
  warnings.insert(warnings.end(), notes.begin(), notes.end());
  entries["warnings"] = warnings;
  entries["remarks"] = found.remarks;
  return entries;
}

void bind_calibrations(py::module_& module) {
  module.def("calibrate", &calibrate_with, py::arg("composites"), py::arg("data"), py::arg("unknowns"),
             py::arg("modulus"), py::arg("stage"), py::arg("noise"), py::arg("model_error"), py::arg("samples"));
}

}  // namespace breccia::python
