#include "deck/sought_input.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/assessment/stage_curves.hpp"
#include "breccia/error.hpp"

#include "assessment/curve_values.hpp"
#include "assessment/remarks.hpp"
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

/// Throws InputError where a study will not have what a condition asks for.
void require_known(const Condition& condition, const std::vector<Observation>& wanted, const CurvesOfStudy& curves) {
  try {
    require_observable({}, wanted, curves);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", condition.quantity, error.what()));
  }
}

/// Throws InputError where boxes are too few to follow an input through them.
void require_enough_boxes(const DeckAssessment& deck, std::size_t input) {
  constexpr Eigen::Index fewest = 4;
  const auto boxes = deck.design().boxes.cols();
  if (!deck.design().change_the_box[input] || boxes >= fewest) return;
  throw InputError(
      fmt::format("boxes: expected {} or more to follow {}, got {}", fewest, deck.inputs()[input].name, boxes));
}

/// What was wanted, in words: "G(1 ms) 3 GPa".
std::string wanted_in_words(const Condition& condition) {
  return fmt::format("{} {}", condition.quantity,
                     value_in_words(condition, as_written(condition, condition.wanted.value)));
}

/// Whether what a composite has is the same over the whole range of an input.
bool changes_nothing(const std::vector<DesignPoint>& points) {
  constexpr double rounding = 1e-9;
  const auto [least, most] = std::ranges::minmax_element(points, {}, &DesignPoint::value);
  return most->value <= least->value * (1.0 + rounding);
}

/// What a composite has over the range of an input in which no value serves.
std::string best_of(const UncertainInput& input, const std::vector<DesignPoint>& points, const Condition& condition) {
  const auto [least, most] = std::ranges::minmax_element(points, {}, &DesignPoint::value);
  const double wanted = as_written(condition, condition.wanted.value);
  const auto& nearest = wanted < least->value ? *least : *most;
  const bool may_serve = nearest.interval.lower <= wanted && wanted <= nearest.interval.upper;
  return fmt::format("no {} from {} to {} makes {}: it is {} at least, with {}, and {} at most, with {}{}", input.name,
                     in_words(input, points.front().input), in_words(input, points.back().input),
                     wanted_in_words(condition), value_in_words(condition, least->value), in_words(input, least->input),
                     value_in_words(condition, most->value), in_words(input, most->input),
                     may_serve ? fmt::format("; within the errors {} may serve", in_words(input, nearest.input)) : "");
}

}  // namespace

SoughtInput read_sought_input(const DeckAssessment& deck, const std::string& key, const std::string& condition,
                              std::optional<double> model_error) {
  SoughtInput sought = {.model_error = model_error};
  std::vector<Observation> wanted;
  CollectedMistakes mistakes;
  mistakes.collect([&] { sought.index = input_named(deck.inputs(), key); });
  mistakes.collect([&] {
    sought.condition = read_condition(condition);
    wanted.push_back(sought.condition.wanted);
  });
  const auto curves = curves_of(deck.sweep().tasks.front().study);
  mistakes.collect([&] { require_observable(deck.inputs(), {}, curves); });
  mistakes.collect([&] { require_known(sought.condition, wanted, curves); });
  mistakes.collect([&] { require_enough_boxes(deck, sought.index); });
  mistakes.collect([&] {
    if (!model_error || sought.condition.wanted.curve != ObservedCurve::phase) return;
    throw InputError("the error of the model is one of moduli; nothing is known of that of a phase");
  });
  mistakes.refuse();
  return sought;
}

FoundDesign find_input(const DeckAssessment& deck, const std::vector<SampledCurve>& curves, const SoughtInput& sought) {
  const auto& input = deck.inputs()[sought.index];
  const auto& condition = sought.condition;
  const bool is_phase = condition.wanted.curve == ObservedCurve::phase;
  const double error = is_phase ? 0.0 : sought.model_error.value_or(stated_error(curves, {condition.wanted}));
  auto found = find_input(deck.inputs(), sought.index, deck.design(), curves, condition.wanted, 0.5 * error);
  for (auto& [place, value, interval] : found.points) {
    value = as_written(condition, value);
    interval = {as_written(condition, interval.lower), as_written(condition, interval.upper)};
  }
  if (changes_nothing(found.points)) {
    throw InputError(fmt::format(
        "{}: the boxes that were solved do not show how {} depends on it; expected more boxes, or a wider range",
        input.name, condition.quantity));
  }
  if (found.scores.empty()) throw InputError(best_of(input, found.points, condition));
  const auto value_at = [&](double score) {
    return std::isinf(score) ? score : value_at_score(std::get<Distribution>(input.known), score);
  };
  if (found.scores.size() > 1) {
    std::vector<std::string> values;
    values.reserve(found.scores.size());
    for (const double score : found.scores) values.push_back(in_words(input, value_at(score)));
    throw InputError(fmt::format("{}: each of {} makes {}; expected a range that holds one of them", input.name,
                                 fmt::join(values, ", "), wanted_in_words(condition)));
  }
  FoundDesign design = {.value = value_at(found.scores.front()),
                        .lower = value_at(found.lower),
                        .upper = value_at(found.upper),
                        .has_model_error = error > 0.0,
                        .without = found.without,
                        .points = std::move(found.points)};
  if (is_phase) {
    design.warnings.emplace_back("the error of the model in a phase is not known and not in the interval");
  } else if (!(error > 0.0)) {
    design.warnings.emplace_back(unknown_model_error);
  }
  const double reach = deck.design().coordinates.row(static_cast<Eigen::Index>(sought.index)).cwiseAbs().maxCoeff();
  if (std::abs(found.scores.front()) > reach) {
    design.warnings.push_back(
        fmt::format("{}: the value is beyond all that were solved; search a range about it", input.name));
  }
  return design;
}

Scalar rounded_value(const UncertainInput& input, double value) {
  constexpr int digits = 4;
  if (input.unit.empty()) return std::stod(fmt::format("{:.{}g}", value, digits));
  return number_in_words(value, input.unit, digits);
}

std::string doubt_on(const FoundDesign& design, const Condition& condition, double reached) {
  const auto place = std::ranges::lower_bound(design.points, design.value, {}, &DesignPoint::input);
  const auto& [at, value, interval] = place == design.points.end() ? design.points.back() : *place;
  if (reached >= interval.lower && reached <= interval.upper) return "";
  return fmt::format(
      "{} of the study is outside of the 95 % expected there, {} to {}: packings scatter more than the "
      "boxes show; solve more boxes, or larger ones",
      condition.quantity, value_in_words(condition, interval.lower), value_in_words(condition, interval.upper));
}

double value_of_study(const std::vector<StageFindings>& stages, const std::string& stage, const Condition& condition) {
  const auto& findings = *std::ranges::find(stages, stage, &StageFindings::name);
  const auto curves = curves_of(findings, kinds_of(findings).front());
  return as_written(condition, observed_value(curves, values_of_sample(curves, 0), condition.wanted));
}

}  // namespace breccia
