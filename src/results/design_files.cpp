#include "results/design_files.hpp"

#include <numbers>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/text_file.hpp"
#include "io/whole_results.hpp"
#include "report/modulus_plot.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

std::vector<CsvColumn> columns_of(const std::vector<DesignPoint>& points) {
  std::vector<double> inputs, values, lower, upper;
  for (const auto& [input, value, interval] : points) {
    inputs.push_back(input);
    values.push_back(value);
    lower.push_back(interval.lower);
    upper.push_back(interval.upper);
  }
  return {{"input", inputs}, {"value", values}, {"lower_95", lower}, {"upper_95", upper}};
}

std::vector<CsvColumn> found_columns(const SearchedDesign& searched) {
  return {{"input", std::vector{searched.input.name}},        {"value", std::vector{searched.value}},
          {"lower_95", std::vector{searched.interval.lower}}, {"upper_95", std::vector{searched.interval.upper}},
          {"wanted", std::vector{searched.wanted}},           {"reached", std::vector{searched.reached}}};
}

/// The unit in which a picture shows values of an SI unit.
struct PictureUnit {
  std::string name;
  double size;
};

PictureUnit picture_unit_of(const std::string& unit) {
  if (unit == "Pa") return {"MPa", 1e6};
  if (unit == "m") return {"um", 1e-6};
  if (unit == "rad") return {"deg", std::numbers::pi / 180.0};
  return {unit, 1.0};
}

/// The scale on which what is known of an input is even.
AxisScale scale_of(const UncertainInput& input) {
  const auto& known = std::get<Distribution>(input.known);
  const bool is_logarithmic = std::holds_alternative<LogNormal>(known) || std::holds_alternative<LogUniform>(known);
  return is_logarithmic ? AxisScale::logarithmic : AxisScale::linear;
}

std::string picture_of(const SearchedDesign& searched) {
  const auto of_input = picture_unit_of(searched.input.unit), of_quantity = picture_unit_of(searched.quantity_unit);
  ModulusPlot plot = {.title = fmt::format("{} by {}", searched.quantity, searched.input.name), .curves = {}};
  plot.quantity = searched.quantity;
  plot.unit = of_quantity.name;
  plot.unit_size = of_quantity.size;
  plot.abscissa = searched.input.name + (of_input.name.empty() ? "" : " / " + of_input.name);
  plot.abscissa_scale = scale_of(searched.input);
  PlotCurve value = {.label = "with the medians of the other inputs", .style = PlotStyle::line, .colour = 0};
  PlotCurve lower = {.label = "95 %", .style = PlotStyle::dashed, .colour = 0};
  PlotCurve upper = {.label = "", .style = PlotStyle::dashed, .colour = 0};
  for (const auto& point : searched.points) {
    for (auto* const curve : {&value, &lower, &upper}) curve->times.push_back(point.input / of_input.size);
    value.moduli.push_back(point.value);
    lower.moduli.push_back(point.interval.lower);
    upper.moduli.push_back(point.interval.upper);
  }
  const PlotCurve wanted = {.label = "wanted",
                            .times = {value.times.front(), value.times.back()},
                            .moduli = {searched.wanted, searched.wanted},
                            .style = PlotStyle::dotted,
                            .colour = 1};
  const PlotCurve study = {.label = "the study with the value found",
                           .times = {searched.value / of_input.size},
                           .moduli = {searched.reached},
                           .style = PlotStyle::points,
                           .colour = 2};
  plot.curves = {std::move(value), std::move(lower), std::move(upper), wanted, study};
  return modulus_plot(plot);
}

}  // namespace

std::vector<std::string> write_design(const DesignDestination& destination, const SearchedDesign& searched) {
  std::vector<std::string> files = {"found.csv", "find.csv", "find.svg"};
  const auto identity = fmt::format("{}\n{}", destination.source, fmt::join(destination.studies, "\n"));
  WholeResults results(destination.directory, {.command = "find",
                                               .source = destination.source,
                                               .identity = content_hash(identity),
                                               .files = files,
                                               .overwrite = true});
  const auto& place = results.place();
  write_csv(place / "found.csv", found_columns(searched),
            "The value that was found, and what the study with it has, in SI units.");
  write_csv(place / "find.csv", columns_of(searched.points),
            fmt::format("{} over {}, in SI units: with the medians of the other inputs, and the ends of 95 %.",
                        searched.quantity, searched.input.name));
  write_text(place / "find.svg", picture_of(searched));
  results.commit();
  return files;
}

}  // namespace breccia
