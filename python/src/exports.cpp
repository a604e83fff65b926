#include "exports.hpp"

#include <complex>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "io/text_file.hpp"
#include "results/composite.hpp"
#include "results/isochronal.hpp"
#include "results/material_card.hpp"
#include "solution.hpp"
#include "views.hpp"
#include "words.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

using OptionalText = std::optional<std::string>;
using OptionalPair = std::optional<std::pair<double, double>>;

Composite composite_in(const Solution& solution, const OptionalText& stage, const OptionalText& boundary,
                       const OptionalText& load) {
  CompositeChoice choice;
  choice.stage = stage.value_or("");
  if (boundary) choice.boundary = value_of<Boundary>("boundary", *boundary);
  if (load) choice.shear_load = value_of<TestLoad>("load", *load);
  std::vector<StageSeries> series;
  for (const auto& solved : solution.stages) {
    for (auto& one : series_of(solved.result)) series.push_back(std::move(one));
  }
  return composite_of(solution.content, series, choice, solution.content.title);
}

std::string card_of(const Composite& composite, const std::string& format, double tolerance, const OptionalPair& times,
                    std::optional<double> bulk, std::optional<double> poisson, const std::string& units) {
  CardSettings settings = {.format = value_of<CardFormat>("format", format),
                           .units = value_of<CardUnits>("units", units),
                           .tolerance = tolerance,
                           .bulk = bulk,
                           .poisson = poisson};
  if (times) settings.times = TimeWindow{times->first, times->second};
  return text_of(material_card(composite, settings), settings);
}

std::vector<IsochronalSample> isochronal_samples(const Composite& composite, double angular_frequency,
                                                 const OptionalPair& temperatures, double step) {
  std::optional<TemperatureRange> range;
  if (temperatures) range = TemperatureRange{temperatures->first, temperatures->second};
  return isochronal_curve(composite, angular_frequency, range, step);
}

/// A quantity of each sample as an array; None where a sample has none.
template <class Number, class Value>
py::object column(const std::vector<IsochronalSample>& samples, const Value& value_of_sample) {
  py::array_t<Number> numbers(static_cast<py::ssize_t>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::optional<Number> value = value_of_sample(samples[i]);
    if (!value) return py::none();
    numbers.mutable_data()[i] = *value;
  }
  return numbers;
}

py::dict isochronal_columns(const std::vector<IsochronalSample>& samples) {
  using Complex = std::complex<double>;
  py::dict columns;
  columns["temperature"] = column<double>(samples, [](const auto& sample) { return sample.temperature; });
  columns["log10_shift_factor"] = column<double>(samples, [](const auto& sample) { return sample.log10_shift_factor; });
  columns["shear"] = column<Complex>(samples, [](const auto& sample) { return sample.shear; });
  columns["young"] = column<Complex>(samples, [](const auto& sample) { return sample.young; });
  columns["poisson"] = column<Complex>(samples, [](const auto& sample) { return sample.poisson; });
  return columns;
}

}  // namespace

void bind_exports(py::module_& module) {
  const py::class_<Composite> bound(module, "Composite", "The moduli of a composite, as an export takes them.");
  module.def("write_text", [](const std::filesystem::path& file, const std::string& text) { write_text(file, text); });
  module.def("composite", &composite_in, py::arg("result"), py::arg("stage"), py::arg("boundary"), py::arg("load"));
  module.def("card", &card_of, py::arg("composite"), py::arg("format"), py::arg("tolerance"), py::arg("times"),
             py::arg("bulk"), py::arg("poisson"), py::arg("units"));
  module.def(
      "isochronal",
      [](const Composite& composite, double angular_frequency, const OptionalPair& temperatures, double step) {
        return isochronal_columns(isochronal_samples(composite, angular_frequency, temperatures, step));
      },
      py::arg("composite"), py::arg("angular_frequency"), py::arg("temperatures"), py::arg("step"));
  module.def(
      "isochronal_table",
      [](const Composite& composite, double angular_frequency, const OptionalPair& temperatures, double step) {
        return table_of(isochronal_samples(composite, angular_frequency, temperatures, step), composite,
                        angular_frequency);
      },
      py::arg("composite"), py::arg("angular_frequency"), py::arg("temperatures"), py::arg("step"));
}

}  // namespace breccia::python
