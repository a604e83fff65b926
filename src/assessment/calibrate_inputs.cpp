#include "breccia/assessment/calibrate_inputs.hpp"

#include <cmath>

#include <fmt/format.h>

#include "assessment/found_scores.hpp"
#include "assessment/polynomial_model.hpp"

namespace breccia {

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
