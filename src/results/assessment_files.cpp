#include "results/assessment_files.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/text_file.hpp"
#include "io/whole_results.hpp"
#include "report/modulus_plot.hpp"
#include "report/share_map.hpp"
#include "results/curve_places.hpp"
#include "results/test_columns.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

std::string column_of_places(Abscissa abscissa) {
  return abscissa == Abscissa::time ? "time_s" : "angular_frequency_rad_per_s";
}

/// The name of a curve as a part of a file name: "K-G-3" of "K + G/3".
std::string file_name_of(const AssessedCurve& curve) {
  std::string name;
  bool is_apart = false;
  for (const char letter : curve.name) {
    const bool is_word = std::isalnum(static_cast<unsigned char>(letter)) != 0;
    if (is_word && is_apart && !name.empty()) name += '-';
    if (is_word) name += letter;
    is_apart = !is_word;
  }
  return name;
}

std::vector<CsvColumn> band_columns(const Assessment& assessment, Abscissa abscissa) {
  std::vector<std::string> names, units, errors, whole_lower, whole_upper;
  std::vector<double> at, references, medians, lower, upper;
  for (const auto& curve : assessment.curves) {
    for (std::size_t i = 0; i < curve.at.size(); ++i) {
      names.push_back(curve.name);
      units.push_back(curve.unit);
      at.push_back(curve.at[i]);
      references.push_back(curve.reference[i]);
      medians.push_back(curve.median[i]);
      lower.push_back(curve.of_inputs[i].lower);
      upper.push_back(curve.of_inputs[i].upper);
      errors.push_back(text_if_known(curve.errors[i]));
      const auto& whole = curve.whole[i];
      whole_lower.push_back(whole ? fmt::format("{}", whole->lower) : "");
      whole_upper.push_back(whole ? fmt::format("{}", whole->upper) : "");
    }
  }
  return {{"curve", names},
          {"unit", units},
          {column_of_places(abscissa), at},
          {"with_median_inputs", references},
          {"median", medians},
          {"inputs_lower_95", lower},
          {"inputs_upper_95", upper},
          {"error_of_model", errors},
          {"whole_lower_95", whole_lower},
          {"whole_upper_95", whole_upper}};
}

std::vector<CsvColumn> sensitivity_columns(const Assessment& assessment, Abscissa abscissa) {
  std::vector<std::string> names, inputs;
  std::vector<double> at, alone, total, unexplained;
  for (const auto& curve : assessment.curves) {
    for (std::size_t i = 0; i < curve.at.size(); ++i) {
      for (std::size_t input = 0; input < assessment.inputs.size(); ++input) {
        const auto row = static_cast<Eigen::Index>(input), column = static_cast<Eigen::Index>(i);
        names.push_back(curve.name);
        at.push_back(curve.at[i]);
        inputs.push_back(assessment.inputs[input].name);
        alone.push_back(curve.alone(row, column));
        total.push_back(curve.total(row, column));
        unexplained.push_back(curve.unexplained[i]);
      }
    }
  }
  return {{"curve", names}, {column_of_places(abscissa), at}, {"input", inputs},
          {"alone", alone}, {"with_others", total},           {"unexplained", unexplained}};
}

std::vector<CsvColumn> input_columns(const std::vector<UncertainInput>& inputs) {
  std::vector<std::string> names, units, choices, medians, lower, upper;
  const double half_width = normal_score(0.975);
  for (const auto& input : inputs) {
    names.push_back(input.name);
    units.push_back(input.unit);
    const auto* const known = std::get_if<Distribution>(&input.known);
    const auto value = [&](double score) {
      return known == nullptr ? "" : fmt::format("{}", value_at_score(*known, score));
    };
    medians.push_back(value(0.0));
    lower.push_back(value(-half_width));
    upper.push_back(value(half_width));
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < choices_of(input); ++i)
      texts.push_back(plain_text(value_at(input, static_cast<double>(i))));
    choices.push_back(fmt::format("{}", fmt::join(texts, "; ")));
  }
  return {{"input", names},    {"unit", units},     {"median", medians},
          {"lower_95", lower}, {"upper_95", upper}, {"choices", choices}};
}

std::string plot_of(const AssessedCurve& curve, Abscissa abscissa) {
  ModulusPlot plot = {.title = fmt::format("{}, 95 %", curve.name), .curves = {}};
  plot.quantity = curve.name;
  if (curve.unit == "rad") {
    plot.unit = "deg";
    plot.unit_size = std::numbers::pi / 180.0;
  }
  if (abscissa == Abscissa::frequency) plot.abscissa = "Frequency / Hz";
  std::vector<double> places;
  places.reserve(curve.at.size());
  for (const double at : curve.at) places.push_back(axis_value(at, abscissa));
  const auto add = [&](const std::string& label, PlotStyle style, std::size_t colour, const auto& value) {
    PlotCurve drawn = {.label = label, .times = {}, .moduli = {}, .style = style, .colour = colour};
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double one = value(i);
      if (!std::isfinite(one)) continue;
      drawn.times.push_back(places[i]);
      drawn.moduli.push_back(one);
    }
    plot.curves.push_back(std::move(drawn));
  };
  add("median", PlotStyle::line, 0, [&](std::size_t i) { return curve.median[i]; });
  add("by the inputs", PlotStyle::dashed, 0, [&](std::size_t i) { return curve.of_inputs[i].lower; });
  add("", PlotStyle::dashed, 0, [&](std::size_t i) { return curve.of_inputs[i].upper; });
  add("with the error of the model", PlotStyle::dotted, 1,
      [&](std::size_t i) { return curve.whole[i] ? curve.whole[i]->lower : not_known; });
  add("", PlotStyle::dotted, 1, [&](std::size_t i) { return curve.whole[i] ? curve.whole[i]->upper : not_known; });
  return modulus_plot(plot);
}

std::string map_of(const AssessedCurve& curve, const std::vector<UncertainInput>& inputs, Abscissa abscissa) {
  ShareMap map = {.title = fmt::format("Share of the inputs in the variance of {}, %", curve.name),
                  .rows = {},
                  .columns = {},
                  .shares = {}};
  const auto decades = decades_of(curve.at, abscissa);
  for (const auto i : decades) map.columns.push_back(place_in_words(curve.at[i], abscissa));
  for (std::size_t input = 0; input < inputs.size(); ++input) {
    map.rows.push_back(short_name(inputs[input]));
    auto& shares = map.shares.emplace_back();
    for (const auto i : decades) {
      shares.push_back(curve.alone(static_cast<Eigen::Index>(input), static_cast<Eigen::Index>(i)));
    }
  }
  if (inputs.size() > 1) {
    const auto interactions = interactions_of(curve);
    map.rows.emplace_back("interactions");
    auto& shares = map.shares.emplace_back();
    for (const auto i : decades) shares.push_back(interactions[i]);
  }
  return share_map(map);
}

}  // namespace

std::string short_name(const UncertainInput& input) {
  return input.name.substr(input.name.find('.') + 1);
}

std::vector<std::string> write_assessment(const AssessmentDestination& destination, const Assessment& assessment,
                                          Abscissa abscissa) {
  std::vector<std::string> files = {"report.html", "inputs.csv", "bands.csv", "sensitivity.csv"};
  for (const auto& curve : assessment.curves) {
    files.push_back(fmt::format("bands_{}.svg", file_name_of(curve)));
    files.push_back(fmt::format("sensitivity_{}.svg", file_name_of(curve)));
  }
  // Those of an earlier assessment with other curves are removed.
  auto possible = files;
  for (const auto* name : {"G", "K", "K-G-3", "phase-of-G", "phase-of-K", "phase-of-K-G-3"}) {
    possible.push_back(fmt::format("bands_{}.svg", name));
    possible.push_back(fmt::format("sensitivity_{}.svg", name));
  }
  const auto identity = fmt::format("{}\n{}", destination.source, fmt::join(destination.studies, "\n"));
  WholeResults results(destination.directory, {.command = "assess",
                                               .source = destination.source,
                                               .identity = content_hash(identity),
                                               .files = possible,
                                               .overwrite = destination.overwrite});
  const auto& place = results.place();
  write_text(place / "report.html", destination.page);
  write_csv(place / "inputs.csv", input_columns(assessment.inputs), "The uncertain inputs, in SI units.");
  write_csv(place / "bands.csv", band_columns(assessment, abscissa),
            "Curves with the uncertainty of the inputs, and with the error of the model beside it, in SI units.");
  write_csv(place / "sensitivity.csv", sensitivity_columns(assessment, abscissa),
            "Shares of the inputs in the variance of the logarithm of a modulus, or of a phase: first-order and total "
            "Sobol' indices; unexplained: the share of the variance that the polynomials do not predict.");
  for (const auto& curve : assessment.curves) {
    write_text(place / fmt::format("bands_{}.svg", file_name_of(curve)), plot_of(curve, abscissa));
    write_text(place / fmt::format("sensitivity_{}.svg", file_name_of(curve)),
               map_of(curve, assessment.inputs, abscissa));
  }
  results.commit();
  return files;
}

}  // namespace breccia
