#include "breccia/assessment/calibrate_inputs.hpp"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "assessment/found_scores.hpp"
#include "assessment/polynomial_model.hpp"
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
  const auto place =
      curves.are_over_frequency ? fmt::format("{:.3g} rad/s", observation.at) : display_time(observation.at);
  if (!is_known(observation, curves.are_over_frequency)) {
    return fmt::format("a measurement of the {} modulus, {}, at {}: expected {}", name_of(observation.modulus),
                       name_of(observation.curve), place,
                       curves.are_over_frequency ? "dynamic moduli, as the study has them"
                                                 : "relaxation moduli in shear or bulk, as the study has them");
  }
  if (observation.modulus != ObservedModulus::shear && !curves.have_bulk) {
    return fmt::format("a measurement of the {} modulus at {}: the study has no test in bulk (tests.loads)",
                       name_of(observation.modulus), place);
  }
  if (observation.temperature) {
    return fmt::format("a measurement at {:.4g} K and {}: expected those at the temperature of the study",
                       *observation.temperature, place);
  }
  constexpr double rounding = 1e-9;
  if (observation.at >= curves.first * (1.0 - rounding) && observation.at <= curves.last * (1.0 + rounding)) return "";
  return fmt::format("a measurement at {}: outside of the curves of the study", place);
}

}  // namespace

void require_observable(const std::vector<UncertainInput>& inputs, const std::vector<Observation>& observations,
                        const CurvesOfStudy& curves) {
  std::vector<std::string> mistakes;
  for (const auto& input : inputs) {
    if (choices_of(input) == 0) continue;
    mistakes.push_back(fmt::format(
        "{}: measurements do not find one of several values; expected one value, or a distribution", input.name));
  }
  for (const auto& observation : observations) {
    if (auto mistake = mistake_in(observation, curves); !mistake.empty()) mistakes.push_back(std::move(mistake));
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
    found.warnings.emplace_back(
        "the error of the model is not known and not in the intervals; state the error of the model");
  }
  constexpr double far = 3.0;
  for (const auto& estimate : found.estimates) {
    if (std::abs(estimate.score) < far) continue;
    found.warnings.push_back(fmt::format(
        "{}: what was found is where only three of a thousand were expected: what is known of it is wrong, or "
        "another input is",
        estimate.name));
  }
  return found;
}

}  // namespace breccia
