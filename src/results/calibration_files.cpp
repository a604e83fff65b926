#include "results/calibration_files.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/words.hpp"

#include "io/text_file.hpp"
#include "io/whole_results.hpp"
#include "report/modulus_plot.hpp"
#include "results/material_files.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

std::vector<CsvColumn> columns_of(const std::vector<Estimate>& estimates) {
  std::vector<std::string> names, units;
  std::vector<double> values, lower, upper, before, lower_before, upper_before, learned;
  const double half_width = normal_score(0.975);
  for (const auto& one : estimates) {
    names.push_back(one.name);
    units.push_back(one.unit);
    values.push_back(one.value);
    lower.push_back(one.interval.lower);
    upper.push_back(one.interval.upper);
    before.push_back(median(one.prior));
    lower_before.push_back(value_at_score(one.prior, -half_width));
    upper_before.push_back(value_at_score(one.prior, half_width));
    learned.push_back(one.learned);
  }
  return {{"unknown", names},
          {"unit", units},
          {"value", values},
          {"lower_95", lower},
          {"upper_95", upper},
          {"before", before},
          {"before_lower_95", lower_before},
          {"before_upper_95", upper_before},
          {"learned", learned}};
}

std::vector<CsvColumn> correlation_columns(const Calibration& calibration) {
  std::vector<std::string> names;
  for (const auto& one : calibration.estimates) names.push_back(one.name);
  std::vector<CsvColumn> columns = {{"unknown", names}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Eigen::VectorXd column = calibration.correlation.col(static_cast<Eigen::Index>(i));
    columns.push_back({names[i], std::vector<double>(column.begin(), column.end())});
  }
  return columns;
}

std::vector<CsvColumn> prediction_columns(const CalibrationData& data, const Calibration& calibration) {
  std::vector<std::string> composites, moduli, curves, units, temperatures;
  std::vector<double> at, measured, predicted, lower, upper, deviations;
  for (std::size_t i = 0; i < data.observations.size(); ++i) {
    const auto& one = data.observations[i];
    const auto& prediction = calibration.predictions[i];
    composites.push_back(data.composites[one.composite]);
    moduli.emplace_back(name_of(one.modulus));
    curves.emplace_back(name_of(one.curve));
    at.push_back(one.at);
    units.emplace_back(is_over_frequency(one.curve) ? "rad/s" : "s");
    temperatures.push_back(one.temperature ? fmt::format("{}", *one.temperature) : "");
    measured.push_back(one.value);
    predicted.push_back(prediction.value);
    lower.push_back(prediction.interval.lower);
    upper.push_back(prediction.interval.upper);
    deviations.push_back(prediction.deviation);
  }
  return {{"composite", composites},
          {"modulus", moduli},
          {"curve", curves},
          {"at", at},
          {"unit_of_at", units},
          {"temperature_K", temperatures},
          {"measured", measured},
          {"predicted", predicted},
          {"predicted_lower_95", lower},
          {"predicted_upper_95", upper},
          {"deviation_in_standard_deviations", deviations}};
}

/// A series of measurements that make one curve: of a composite, a modulus and a kind of curve at a temperature.
using SeriesKey = std::tuple<std::size_t, ObservedModulus, ObservedCurve, double>;

std::string symbol_of(ObservedModulus modulus, ObservedCurve curve) {
  const std::map<ObservedModulus, std::string> letters = {{ObservedModulus::shear, "G"},
                                                          {ObservedModulus::young, "E"},
                                                          {ObservedModulus::bulk, "K"},
                                                          {ObservedModulus::p_wave, "M"}};
  const auto& letter = letters.at(modulus);
  if (curve == ObservedCurve::storage) return letter + "'";
  if (curve == ObservedCurve::loss) return letter + "''";
  if (curve == ObservedCurve::creep) return fmt::format("1/J(t) of {}", letter);
  return curve == ObservedCurve::absolute ? fmt::format("|{}*|", letter) : letter + "(t)";
}

std::string label_of(const SeriesKey& key, const CalibrationData& data) {
  const auto& [composite, modulus, curve, temperature] = key;
  auto label = fmt::format("{}, {}", data.composites[composite], symbol_of(modulus, curve));
  constexpr double zero_celsius = 273.15;
  if (temperature > 0.0) label += fmt::format(" at {:.4g} degC", temperature - zero_celsius);
  return label;
}

/// The moduli of the measurements with these indices over time, with those over frequency at the times 1/omega.
/// Compliances are drawn by their reciprocals.
template <class Value>
PlotCurve curve_of(const std::vector<Observation>& observations, const std::vector<std::size_t>& indices,
                   const Value& value_at) {
  PlotCurve drawn;
  for (const auto i : indices) {
    const auto& one = observations[i];
    drawn.times.push_back(is_over_frequency(one.curve) ? 1.0 / one.at : one.at);
    drawn.moduli.push_back(one.curve == ObservedCurve::creep ? 1.0 / value_at(i) : value_at(i));
  }
  return drawn;
}

/// The measured and the predicted moduli. Phases are not drawn.
std::string prediction_plot(const CalibrationData& data, const Calibration& calibration) {
  std::map<SeriesKey, std::vector<std::size_t>> series;
  for (std::size_t i = 0; i < data.observations.size(); ++i) {
    const auto& one = data.observations[i];
    if (one.curve == ObservedCurve::phase) continue;
    series[{one.composite, one.modulus, one.curve, one.temperature.value_or(0.0)}].push_back(i);
  }
  ModulusPlot plot = {.title = "Measured and predicted", .curves = {}};
  plot.quantity = "Modulus";
  plot.abscissa = "Time / s, or 1/angular frequency / s";
  const auto& predictions = calibration.predictions;
  std::size_t colour = 0;
  for (const auto& one : series) {
    const auto add = [&](PlotStyle style, const std::string& label, const auto& value_at) {
      auto curve = curve_of(data.observations, one.second, value_at);
      curve.label = label;
      curve.style = style;
      curve.colour = colour;
      plot.curves.push_back(std::move(curve));
    };
    const auto label = label_of(one.first, data);
    add(PlotStyle::points, label + ", measured", [&](std::size_t i) { return data.observations[i].value; });
    add(PlotStyle::line, label + ", predicted", [&](std::size_t i) { return predictions[i].value; });
    add(PlotStyle::dotted, label + ", 95 %", [&](std::size_t i) { return predictions[i].interval.lower; });
    add(PlotStyle::dotted, "", [&](std::size_t i) { return predictions[i].interval.upper; });
    ++colour;
  }
  return plot.curves.empty() ? "" : modulus_plot(plot);
}

ResultsOrigin origin_of(const CalibrationDestination& destination, const Calibration& calibration) {
  std::vector<std::string> files = {"estimates.csv", "correlations.csv", "predictions.csv", "predictions.svg"};
  for (const auto& material : calibration.materials) {
    std::ranges::move(material_files(material.material.name), std::back_inserter(files));
  }
  refuse_to_replace(destination.directory, files, destination.inputs);
  auto identity = fmt::format("{}\n{}", destination.source, fmt::join(destination.studies, "\n"));
  for (const auto& input : destination.inputs) identity += fmt::format("\n{}", content_hash(read_text(input)));
  return {.command = "calibrate",
          .source = destination.source,
          .identity = content_hash(identity),
          .files = files,
          .overwrite = destination.overwrite};
}

}  // namespace

std::vector<std::string> write_calibration(const CalibrationDestination& destination, const CalibrationData& data,
                                           const Calibration& calibration) {
  WholeResults results(destination.directory, origin_of(destination, calibration));
  const auto& place = results.place();
  std::vector<std::string> names = {"estimates.csv", "correlations.csv", "predictions.csv"};
  write_csv(place / "estimates.csv", columns_of(calibration.estimates),
            "What a calibration has found, in SI units; learned: the share of the variance that the data removed.");
  write_csv(place / "correlations.csv", correlation_columns(calibration), "Correlations of the unknowns.");
  write_csv(
      place / "predictions.csv", prediction_columns(data, calibration),
      fmt::format("Measured values beside the predictions, in SI units; standard deviation of the data: {:.4g} %.",
                  100.0 * calibration.noise * data.observations.front().deviation));
  if (const auto plot = prediction_plot(data, calibration); !plot.empty()) {
    write_text(place / "predictions.svg", plot);
    names.emplace_back("predictions.svg");
  }
  for (const auto& material : calibration.materials) {
    const auto comment =
        fmt::format("{} as a calibration has found it, for breccia respond --material", material.material.name);
    std::ranges::move(write_material(place, material, comment), std::back_inserter(names));
  }
  results.commit();
  return names;
}

}  // namespace breccia
