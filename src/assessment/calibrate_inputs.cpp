#include "breccia/assessment/calibrate_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "assessment/found_scores.hpp"
#include "assessment/polynomial_model.hpp"
#include "assessment/remarks.hpp"
#include "io/collected_mistakes.hpp"
#include "io/display.hpp"

namespace breccia {
namespace {

/// What the curves of a study over time, or over frequency, may be compared with.
bool is_known(const Observation& observation, bool are_over_frequency) {
  if (is_over_frequency(observation.curve) != are_over_frequency) return false;
  if (are_over_frequency) return true;
  // Young's modulus over time does not follow from G and K at that time alone.
  return observation.curve == ObservedCurve::relaxation && observation.modulus != ObservedModulus::young;
}

std::string mistake_in(const Observation& observation, const CurvesOfStudy& curves) {
  if (!is_known(observation, curves.are_over_frequency)) {
    return fmt::format("{} modulus ({}): expected {}, as the study has it", name_of(observation.modulus),
                       name_of(observation.curve),
                       curves.are_over_frequency ? "a dynamic modulus at a frequency"
                                                 : "a relaxation modulus in shear or bulk at a time");
  }
  if (observation.modulus != ObservedModulus::shear && !curves.have_bulk) {
    return fmt::format("{} modulus: the study has no test in bulk (tests.loads)", name_of(observation.modulus));
  }
  if (observation.temperature) {
    return fmt::format("measurements at {:.4g} K: expected those at the temperature of the study",
                       *observation.temperature);
  }
  constexpr double rounding = 1e-9;
  if (observation.at >= curves.first * (1.0 - rounding) && observation.at <= curves.last * (1.0 + rounding)) return "";
  const auto in_words = [&](double place) {
    return curves.are_over_frequency ? display(place / (2.0 * std::numbers::pi), "Hz") : display_time(place);
  };
  return fmt::format("outside of the curves of the study, {} to {}: change its {}, or leave such values out",
                     in_words(curves.first), in_words(curves.last),
                     curves.are_over_frequency ? "frequencies" : "times");
}

}  // namespace

void require_observable(const std::vector<UncertainInput>& inputs, const std::vector<Observation>& observations,
                        const CurvesOfStudy& curves) {
  std::vector<std::string> mistakes;
  for (const auto& input : inputs) {
    if (choices_of(input) == 0) continue;
    mistakes.push_back(
        fmt::format("{}: any of several values; expected one value, or a distribution over a range", input.name));
  }
  for (const auto& observation : observations) {
    auto mistake = mistake_in(observation, curves);
    if (mistake.empty() || std::ranges::find(mistakes, mistake) != mistakes.end()) continue;
    mistakes.push_back(std::move(mistake));
  }
  refuse_unless_empty(mistakes);
}

Calibration calibrate_inputs(const std::vector<UncertainInput>& inputs, const AssessmentDesign& design,
                             const std::vector<SampledCurve>& curves, const std::vector<Observation>& observations,
                             double model_deviation, const CalibrationOptions& options) {
  const PolynomialModel model(inputs, design, curves, observations, model_deviation);
  const PriorOfScores prior = {.deviations = Eigen::VectorXd::Ones(model.size()),
                               .curvature = Eigen::MatrixXd::Zero(0, model.size())};
  auto [middle, found] = find_scores(model, prior, options);
  if (!(model_deviation > 0.0)) {
    found.warnings.emplace_back(unknown_model_error);
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto& estimate = found.estimates[i];
    const double reach = design.coordinates.row(static_cast<Eigen::Index>(i)).cwiseAbs().maxCoeff();
    if (std::abs(estimate.score) <= reach) continue;
    found.warnings.push_back(
        fmt::format("{}: what was found is beyond all {} that were solved: what is known of it is wrong, another input "
                    "is, or there "
                    "are too few",
                    estimate.name, design.change_the_box[i] ? "boxes" : "samples"));
  }
  return found;
}

}  // namespace breccia
