#include "cli/assessment_tables.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/calibration_tables.hpp"
#include "io/display.hpp"
#include "results/assessment_files.hpp"
#include "results/curve_places.hpp"

namespace breccia::cli {
namespace {

std::string value_of(const AssessedCurve& curve, double value) {
  if (curve.unit == "Pa") return display(value, "Pa");
  return fmt::format("{:.3g} deg", value * 180.0 / std::numbers::pi);
}

/// A share in per cent, or "-" where shares mean nothing, in a column of some width.
std::string share_in_words(bool is_shown, double share, std::size_t width) {
  return fmt::format("{:>{}}", is_shown ? fmt::format("{:.0f} %", 100.0 * share) : "-", width);
}

std::string interval_of(const AssessedCurve& curve, const std::optional<Interval>& interval) {
  if (!interval) return "not known";
  return fmt::format("{} to {}", value_of(curve, interval->lower), value_of(curve, interval->upper));
}

}  // namespace

std::string in_words(const UncertainInput& input) {
  if (const auto* const known = std::get_if<Distribution>(&input.known)) return in_words(*known, input.unit);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < choices_of(input); ++i) {
    texts.push_back(plain_text(value_at(input, static_cast<double>(i))));
  }
  return fmt::format("any of {}", fmt::join(texts, ", "));
}

std::string table_of_inputs(const std::vector<UncertainInput>& inputs, const std::vector<bool>& change_the_box) {
  std::size_t width = 0;
  for (const auto& input : inputs) width = std::max(width, input.name.size());
  std::string text;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    text += fmt::format("  {:<{}}  {}{}\n", inputs[i].name, width, in_words(inputs[i]),
                        change_the_box[i] ? " (a box for each value)" : "");
  }
  return text;
}

std::string table_of_curve(const AssessedCurve& curve, const std::vector<UncertainInput>& inputs, Abscissa abscissa) {
  constexpr std::size_t narrowest = 8;
  std::vector<std::string> names;
  names.reserve(inputs.size());
  for (const auto& input : inputs) names.push_back(short_name(input));
  auto text =
      fmt::format("{}\n{:>10}  {:>10}  {:>22}  {:>22}", curve.name, abscissa == Abscissa::time ? "time" : "frequency",
                  "median", "95 % by the inputs", "and with the model");
  for (const auto& name : names) text += fmt::format("  {:>{}}", name, std::max(name.size(), narrowest));
  text += inputs.size() > 1 ? "  interactions\n" : "\n";
  const auto interactions = interactions_of(curve);
  for (const auto i : decades_of(curve.at, abscissa)) {
    text += fmt::format("{:>10}  {:>10}  {:>22}  {:>22}", place_in_words(curve.at[i], abscissa),
                        value_of(curve, curve.median[i]), interval_of(curve, curve.of_inputs[i]),
                        interval_of(curve, curve.whole[i]));
    const bool is_shown = has_shares(curve, i);
    for (std::size_t input = 0; input < names.size(); ++input) {
      const double share = curve.alone(static_cast<Eigen::Index>(input), static_cast<Eigen::Index>(i));
      text += "  " + share_in_words(is_shown, share, std::max(names[input].size(), narrowest));
    }
    text += inputs.size() > 1
                ? "  " + share_in_words(is_shown, interactions[i], std::string_view("interactions").size()) + "\n"
                : "\n";
  }
  return text;
}

}  // namespace breccia::cli
