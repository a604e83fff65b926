#include "breccia/assessment/calibrate.hpp"

#include <fmt/format.h>

#include "assessment/coverage.hpp"
#include "assessment/found_scores.hpp"
#include "assessment/observed_model.hpp"

namespace breccia {

Calibration calibrate(const std::vector<ObservedComposite>& composites, const std::vector<Unknown>& unknowns,
                      const std::vector<Observation>& observations, const CalibrationOptions& options) {
  const ObservedModel model(composites, unknowns, observations);
  PriorOfScores prior = {.deviations = Eigen::VectorXd::Ones(model.size()),
                         .curvature = Eigen::MatrixXd::Zero(model.unknowns().curvature().rows(), model.size())};
  prior.deviations.head(model.unknowns().size()) = model.unknowns().prior_deviations();
  prior.curvature.leftCols(model.unknowns().size()) = model.unknowns().curvature();
  auto [middle, found] = find_scores(model, prior, options);
  found.materials = model.unknowns().materials_at(middle);
  found.warnings = warnings_on_coverage(model, middle, found.estimates);
  for (const auto& composite : composites) {
    if (composite.model_deviation > 0.0) continue;
    found.warnings.push_back(
        fmt::format("{}: the error of its model is not known and not in the intervals; state the error of the model",
                    composite.name));
  }
  return found;
}

}  // namespace breccia
