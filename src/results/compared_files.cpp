#include "results/compared_files.hpp"

#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/text_file.hpp"
#include "io/whole_results.hpp"
#include "report/modulus_plot.hpp"
#include "results/curve_places.hpp"
#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

constexpr auto picture_of_shear = "compare_shear.svg", picture_of_bulk = "compare_bulk.svg";

Abscissa abscissa_of(const ComparedCurve& curve) {
  return is_over_frequency(curve.curve) ? Abscissa::frequency : Abscissa::time;
}

std::vector<CsvColumn> curve_columns(const ComparedResults& compared) {
  std::vector<std::string> results, names, units, errors, ratios, errors_of_ratios;
  std::vector<double> at, values;
  for (const auto& curve : compared.curves.curves) {
    for (std::size_t result = 0; result < compared.names.size(); ++result) {
      for (std::size_t i = 0; i < curve.at.size(); ++i) {
        const auto [ratio, error] = difference_from_first(curve, result, i);
        results.push_back(compared.names[result]);
        names.push_back(curve.name);
        units.push_back(curve.unit);
        at.push_back(axis_value(curve.at[i], abscissa_of(curve)));
        values.push_back(curve.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(result)));
        errors.push_back(text_if_known(curve.errors[result][i]));
        ratios.push_back(curve.curve == ObservedCurve::phase ? "" : fmt::format("{}", ratio));
        errors_of_ratios.push_back(text_if_known(error));
      }
    }
  }
  const bool is_in_time = abscissa_of(compared.curves.curves.front()) == Abscissa::time;
  return {{"result", results},
          {"curve", names},
          {"unit", units},
          {is_in_time ? "time_s" : "frequency_Hz", at},
          {"value", values},
          {"error", errors},
          {"ratio_to_first", ratios},
          {"error_of_ratio", errors_of_ratios}};
}

std::vector<CsvColumn> deck_columns(const ComparedResults& compared) {
  std::vector<std::string> paths;
  std::vector<std::vector<std::string>> texts(compared.names.size());
  for (const auto& difference : compared.decks) {
    paths.push_back(difference.path);
    for (std::size_t i = 0; i < texts.size(); ++i) texts[i].push_back(difference.texts[i]);
  }
  std::vector<CsvColumn> columns = {{"value", paths}};
  for (std::size_t i = 0; i < texts.size(); ++i) columns.push_back(CsvColumn{compared.names[i], texts[i]});
  return columns;
}

/// Whether measured values are those of a curve. K is not measured together with a share of G.
bool are_points_of(const Observation& observation, const ComparedCurve& curve) {
  return observation.curve == curve.curve && observation.modulus == curve.modulus && curve.share_of_shear == 0.0;
}

std::string picture_of(const ComparedCurve& curve, const ComparedResults& compared) {
  const auto abscissa = abscissa_of(curve);
  ModulusPlot plot = {.title = curve.name, .curves = {}};
  plot.quantity = curve.name;
  if (abscissa == Abscissa::frequency) plot.abscissa = "Frequency / Hz";
  for (std::size_t result = 0; result < compared.names.size(); ++result) {
    PlotCurve drawn = {.label = compared.names[result]};
    for (std::size_t i = 0; i < curve.at.size(); ++i) {
      drawn.times.push_back(axis_value(curve.at[i], abscissa));
      drawn.moduli.push_back(curve.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(result)));
    }
    plot.curves.push_back(std::move(drawn));
  }
  PlotCurve measured = {.label = "measured", .style = PlotStyle::points};
  for (const auto& observation : compared.measured) {
    if (!are_points_of(observation, curve)) continue;
    measured.times.push_back(axis_value(observation.at, abscissa));
    measured.moduli.push_back(observation.value);
  }
  plot.curves.push_back(std::move(measured));
  return modulus_plot(plot);
}

}  // namespace

std::vector<std::string> write_compared(const ComparisonDestination& destination, const ComparedResults& compared) {
  std::vector<std::pair<std::string, std::string>> pictures;
  for (const auto& curve : compared.curves.curves) {
    if (curve.curve == ObservedCurve::phase) continue;
    pictures.emplace_back(pictures.empty() ? picture_of_shear : picture_of_bulk, picture_of(curve, compared));
  }
  WholeResults results(destination.directory, {.command = "compare",
                                               .source = fmt::format("{}", fmt::join(compared.names, ", ")),
                                               .identity = content_hash(destination.identity),
                                               .files = {"compare.csv", "decks.csv", picture_of_shear, picture_of_bulk},
                                               .overwrite = destination.overwrite});
  const auto& place = results.place();
  write_csv(
      place / "compare.csv", curve_columns(compared),
      "Curves of several results, and their ratios to those of the first, with the errors that the results state.");
  write_csv(place / "decks.csv", deck_columns(compared), "The values in which the decks differ.");
  std::vector<std::string> files = {"compare.csv", "decks.csv"};
  for (const auto& [name, picture] : pictures) {
    write_text(place / name, picture);
    files.push_back(name);
  }
  results.commit();
  return files;
}

}  // namespace breccia
