#include "breccia/assessment/calibrate.hpp"

#include <algorithm>
#include <cmath>

#include "assessment/gaussian_posterior.hpp"
#include "assessment/observed_model.hpp"

namespace breccia {
namespace {

/// Half of the width of an interval that holds 95 % of a normal variable, in standard deviations.
const double half_width = normal_score(0.975);

Estimate estimate_of(const UnknownComponent& component, double score, double variance, double prior_variance) {
  const double deviation = std::sqrt(variance);
  const auto value_at = [&](double at) { return value_at_score(component.prior, at); };
  return {.name = component.name,
          .unit = component.unit,
          .prior = component.prior,
          .value = value_at(score),
          .interval = {value_at(score - half_width * deviation), value_at(score + half_width * deviation)},
          .score = score,
          .deviation = deviation,
          .learned = std::clamp(1.0 - variance / prior_variance, 0.0, 1.0)};
}

/// The predictions with the uncertainty of the unknowns, to first order.
std::vector<PredictedObservation> predicted(const ObservedModel& model, const GaussianPosterior& posterior) {
  const auto values = model.predictions(posterior.mode);
  const auto deviations = model.deviations(posterior.mode);
  const auto jacobian = model.jacobian(posterior.mode);
  std::vector<PredictedObservation> predictions;
  for (std::size_t i = 0; i < model.observations().size(); ++i) {
    const auto& observation = model.observations()[i];
    const auto row = static_cast<Eigen::Index>(i);
    const double spread = half_width * observation.deviation *
                          std::sqrt(jacobian.row(row) * posterior.covariance * jacobian.row(row).transpose());
    const double value = values[row];
    const bool is_phase = observation.curve == ObservedCurve::phase;
    predictions.push_back({.value = value,
                           .interval = is_phase ? Interval{value - spread, value + spread}
                                                : Interval{value * std::exp(-spread), value * std::exp(spread)},
                           .deviation = -deviations[row] / posterior.noise});
  }
  return predictions;
}

Eigen::MatrixXd correlation_of(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd inverse_deviations = covariance.diagonal().cwiseSqrt().cwiseInverse();
  return inverse_deviations.asDiagonal() * covariance * inverse_deviations.asDiagonal();
}

}  // namespace

Calibration calibrate(const std::vector<ObservedComposite>& composites, const std::vector<Unknown>& unknowns,
                      const std::vector<Observation>& observations, Noise noise) {
  const ObservedModel model(composites, unknowns, observations);
  Eigen::MatrixXd curvature = Eigen::MatrixXd::Zero(model.unknowns().curvature().rows(), model.size());
  curvature.leftCols(model.unknowns().size()) = model.unknowns().curvature();
  const InverseProblem problem = {
      .observations = static_cast<Eigen::Index>(observations.size()),
      .deviations = [&model](const Eigen::VectorXd& scores) { return model.deviations(scores); },
      .jacobian = [&model](const Eigen::VectorXd& scores) { return model.jacobian(scores); },
      .curvature = std::move(curvature)};
  const auto posterior = find_posterior(problem, noise);

  Calibration found = {.correlation = correlation_of(posterior.covariance),
                       .predictions = predicted(model, posterior),
                       .materials = model.unknowns().materials_at(posterior.mode),
                       .noise = posterior.noise,
                       .misfit = posterior.misfit,
                       .determined = posterior.determined,
                       .has_converged = posterior.has_converged};
  for (std::size_t c = 0; c < model.components().size(); ++c) {
    const auto index = static_cast<Eigen::Index>(c);
    found.estimates.push_back(estimate_of(model.components()[c], posterior.mode[index],
                                          posterior.covariance(index, index), posterior.prior_variances[index]));
  }
  return found;
}

}  // namespace breccia
