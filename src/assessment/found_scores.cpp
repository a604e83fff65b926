#include "assessment/found_scores.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "assessment/ensemble_sampler.hpp"
#include "assessment/gaussian_posterior.hpp"
#include "assessment/remarks.hpp"
#include "assessment/spread.hpp"

namespace breccia {
namespace {

/// Half of the width of an interval that holds 95 %, in standard deviations: of a normal variable or, where the noise
/// was found from the data as well, of Student's t with the number of data that determine no unknown.
double half_width(const PredictiveModel& model, const GaussianPosterior& posterior, Noise noise) {
  constexpr double upper = 0.975;
  if (noise == Noise::known) return normal_score(upper);
  return student_score(upper, static_cast<double>(model.observations().size()) - posterior.determined);
}

/// Throws InputError where too few data are left to tell their noise.
void require_enough_data(const PredictiveModel& model, const GaussianPosterior& posterior) {
  constexpr double fewest = 3.0;
  const auto count = model.observations().size();
  if (static_cast<double>(count) - posterior.determined >= fewest) return;
  throw InputError(
      fmt::format("{} measured values determine {:.1f} unknowns: too few are left to estimate the noise of the data; "
                  "state the noise",
                  count, posterior.determined));
}

/// An estimate of a component from its score and the scores at the ends of its interval.
Estimate estimate_of(const UnknownComponent& component, double score, const Interval& scores, double deviation,
                     double prior_variance) {
  const auto value_at = [&](double at) { return value_at_score(component.prior, at); };
  return {.name = component.name,
          .unit = component.unit,
          .prior = component.prior,
          .value = value_at(score),
          .interval = {value_at(scores.lower), value_at(scores.upper)},
          .score = score,
          .deviation = deviation,
          .learned = std::clamp(1.0 - deviation * deviation / prior_variance, 0.0, 1.0)};
}

/// The estimates by the normal distribution about the mode.
std::vector<Estimate> normal_estimates(const PredictiveModel& model, const GaussianPosterior& posterior,
                                       double half_width) {
  std::vector<Estimate> estimates;
  for (std::size_t c = 0; c < model.components().size(); ++c) {
    const auto index = static_cast<Eigen::Index>(c);
    const double score = posterior.mode[index], deviation = std::sqrt(posterior.covariance(index, index));
    const Interval scores = {score - half_width * deviation, score + half_width * deviation};
    estimates.push_back(estimate_of(model.components()[c], score, scores, deviation, posterior.prior_variances[index]));
  }
  return estimates;
}

/// The predictions with the uncertainty of the unknowns, to first order.
std::vector<PredictedObservation> normal_predictions(const PredictiveModel& model, const GaussianPosterior& posterior,
                                                     double half_width) {
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

/// Replaces what the normal distribution says of the posterior by samples of it. Returns the medians of the scores.
Eigen::VectorXd take_samples(const PredictiveModel& model, const InverseProblem& problem,
                             const GaussianPosterior& posterior, int samples, Calibration& found) {
  const auto size = static_cast<int>(model.size());
  EnsembleOptions options;
  options.walkers = std::max(4 * size, 20);
  options.steps = (samples + options.walkers - 1) / options.walkers;
  options.burn_in = options.steps / 2;
  const auto ensemble =
      sample_density([&](const Eigen::VectorXd& scores) { return log_density(problem, posterior, scores); },
                     posterior.mode, posterior.covariance, options);
  found.independent_samples = ensemble.independent_samples;

  Eigen::VectorXd medians(model.size());
  for (Eigen::Index c = 0; c < model.size(); ++c) {
    const Eigen::VectorXd scores = ensemble.samples.row(c);
    const auto [middle, interval] = spread_of(scores);
    medians[c] = middle;
    const double deviation =
        std::sqrt((scores.array() - scores.mean()).square().sum() / static_cast<double>(scores.size() - 1));
    found.estimates[static_cast<std::size_t>(c)] = estimate_of(model.components()[static_cast<std::size_t>(c)], middle,
                                                               interval, deviation, posterior.prior_variances[c]);
  }
  const Eigen::MatrixXd centred = ensemble.samples.colwise() - ensemble.samples.rowwise().mean();
  found.correlation = correlation_of(centred * centred.transpose());

  // The intervals of the predictions need fewer samples.
  constexpr Eigen::Index most = 400;
  const auto stride = std::max<Eigen::Index>(ensemble.samples.cols() / most, 1);
  Eigen::MatrixXd predictions(static_cast<Eigen::Index>(found.predictions.size()), ensemble.samples.cols() / stride);
  for (Eigen::Index i = 0; i < predictions.cols(); ++i) {
    predictions.col(i) = model.predictions(ensemble.samples.col(i * stride));
  }
  const auto values = model.predictions(medians), deviations = model.deviations(medians);
  for (std::size_t i = 0; i < found.predictions.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    found.predictions[i] = {.value = values[row],
                            .interval = spread_of(predictions.row(row)).interval,
                            .deviation = -deviations[row] / posterior.noise};
  }
  return medians;
}

}  // namespace

FoundScores find_scores(const PredictiveModel& model, const PriorOfScores& prior, const CalibrationOptions& options) {
  const InverseProblem problem = {
      .observations = static_cast<Eigen::Index>(model.observations().size()),
      .deviations = [&model](const Eigen::VectorXd& scores) { return model.deviations(scores); },
      .jacobian = [&model](const Eigen::VectorXd& scores) { return model.jacobian(scores); },
      .prior_deviations = prior.deviations,
      .curvature = prior.curvature};
  const auto posterior = find_posterior(problem, options.noise);
  if (!posterior.mode.allFinite() || !posterior.covariance.allFinite()) {
    throw NumericalError("the search for the unknowns has left the numbers that a computer has: state more of them");
  }
  if (options.noise == Noise::relative) require_enough_data(model, posterior);
  const double half = half_width(model, posterior, options.noise);

  FoundScores found = {.middle = posterior.mode,
                       .calibration = {.estimates = normal_estimates(model, posterior, half),
                                       .correlation = correlation_of(posterior.covariance),
                                       .predictions = normal_predictions(model, posterior, half),
                                       .noise = posterior.noise,
                                       .misfit = posterior.misfit,
                                       .determined = posterior.determined,
                                       .has_converged = posterior.has_converged}};
  if (options.samples > 0) found.middle = take_samples(model, problem, posterior, options.samples, found.calibration);
  found.calibration.remarks = remarks_on(found.calibration, model.observations(), options.noise);
  return found;
}

}  // namespace breccia
