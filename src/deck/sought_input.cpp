#include "deck/sought_input.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "assessment/curve_values.hpp"
#include "assessment/sampled_curves.hpp"
#include "deck/curves_of_study.hpp"
#include "io/collected_mistakes.hpp"
#include "io/display.hpp"

namespace breccia {
namespace {

/// The index of the input whose path ends with a key.
std::size_t input_named(const std::vector<UncertainInput>& inputs, const std::string& key) {
  std::vector<std::string> names, found;
  std::size_t index = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    names.push_back(inputs[i].name);
    if (inputs[i].name != key && !inputs[i].name.ends_with("." + key)) continue;
    index = i;
    found.push_back(inputs[i].name);
  }
  if (found.size() == 1) return index;
  if (!found.empty()) {
    throw InputError(fmt::format("\"{}\": expected one of {}", key, fmt::join(found, ", ")));
  }
  throw InputError(
      fmt::format("\"{}\" is not one of the uncertain inputs of the deck ({}); a range to search is written as one, "
                  "{{ from = 0.4, to = 0.6 }}, in the deck or by --set",
                  key, fmt::join(names, ", ")));
}

std::string in_words(const UncertainInput& input, double value) {
  return number_in_words(value, input.unit);
}

/// The value at a score, to four digits, as a deck has it: 0.5073, "131.2 MPa".
Scalar rounded_value(const UncertainInput& input, double score) {
  constexpr int digits = 4;
  const double value = value_at_score(std::get<Distribution>(input.known), score);
  if (input.unit.empty()) return std::stod(fmt::format("{:.{}g}", value, digits));
  return number_in_words(value, input.unit, digits);
}

/// What was wanted, in words: "G(1 ms) 3 GPa".
std::string wanted_in_words(const Condition& condition) {
  return fmt::format("{} {}", condition.quantity,
                     value_in_words(condition, as_written(condition, condition.wanted.value)));
}

/// What a composite has over the range of an input in which no value serves.
std::string best_of(const UncertainInput& input, const std::vector<DesignPoint>& points, const Condition& condition) {
  const auto [least, most] = std::ranges::minmax_element(points, {}, &DesignPoint::value);
  return fmt::format("no {} from {} to {} makes {}: it is {} at least, with {}, and {} at most, with {}", input.name,
                     in_words(input, points.front().input), in_words(input, points.back().input),
                     wanted_in_words(condition), value_in_words(condition, least->value), in_words(input, least->input),
                     value_in_words(condition, most->value), in_words(input, most->input));
}

}  // namespace

SoughtInput read_sought_input(const DeckAssessment& deck, const std::string& key, const std::string& condition,
                              std::optional<double> model_error) {
  SoughtInput sought = {.model_error = model_error};
  CollectedMistakes mistakes;
  mistakes.collect([&] { sought.index = input_named(deck.inputs(), key); });
  mistakes.collect([&] {
    sought.condition = read_condition(condition);
    require_observable(deck.inputs(), {sought.condition.wanted}, curves_of(deck.sweep().tasks.front().study.tests));
  });
  mistakes.refuse();
  return sought;
}

FoundDesign find_input(const DeckAssessment& deck, const std::vector<SampledCurve>& curves, const SoughtInput& sought) {
  const auto& input = deck.inputs()[sought.index];
  const auto& condition = sought.condition;
  const double error = sought.model_error.value_or(stated_error(curves, {condition.wanted}));
  auto found = find_input(deck.inputs(), sought.index, deck.design(), curves, condition.wanted, 0.5 * error);
  for (auto& [place, value, interval] : found.points) {
    value = as_written(condition, value);
    interval = {as_written(condition, interval.lower), as_written(condition, interval.upper)};
  }
  if (found.scores.empty()) throw InputError(best_of(input, found.points, condition));
  const auto value_at = [&](double score) { return value_at_score(std::get<Distribution>(input.known), score); };
  if (found.scores.size() > 1) {
    std::vector<std::string> values;
    for (const double score : found.scores) values.push_back(in_words(input, value_at(score)));
    throw InputError(fmt::format("{}: each of {} makes {}; expected a range that holds one of them", input.name,
                                 fmt::join(values, ", "), wanted_in_words(condition)));
  }
  FoundDesign design = {.value = rounded_value(input, found.scores.front()), .points = std::move(found.points)};
  if (found.lower) design.lower = value_at(*found.lower);
  if (found.upper) design.upper = value_at(*found.upper);
  if (!(error > 0.0)) design.warnings.emplace_back(unknown_model_error);
  return design;
}

double value_of_study(const std::vector<StageFindings>& stages, const std::string& stage, const Condition& condition) {
  const auto curves = curves_of(*std::ranges::find(stages, stage, &StageFindings::name));
  return as_written(condition, observed_value(curves, values_of_sample(curves, 0), condition.wanted));
}

}  // namespace breccia
