#include "breccia/assessment/calibrate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "assessment/coverage.hpp"
#include "assessment/ensemble_sampler.hpp"
#include "assessment/gaussian_posterior.hpp"
#include "assessment/observed_model.hpp"

namespace breccia {
namespace {

/// Half of the width of an interval that holds 95 % of a normal variable, in standard deviations.
const double half_width = normal_score(0.975);

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
std::vector<Estimate> normal_estimates(const ObservedModel& model, const GaussianPosterior& posterior) {
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
std::vector<PredictedObservation> normal_predictions(const ObservedModel& model, const GaussianPosterior& posterior) {
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

/// The value below which a share of numbers lies.
double quantile(std::vector<double> numbers, double share) {
  const auto index = static_cast<std::size_t>(share * static_cast<double>(numbers.size() - 1));
  std::ranges::nth_element(numbers, numbers.begin() + static_cast<std::ptrdiff_t>(index));
  return numbers[index];
}

/// The middle and the interval of 95 % of numbers.
struct Spread {
  double median;
  Interval interval;
};

Spread spread_of(const Eigen::VectorXd& numbers) {
  constexpr double tail = 0.025;
  const std::vector<double> all(numbers.begin(), numbers.end());
  return {quantile(all, 0.5), {quantile(all, tail), quantile(all, 1.0 - tail)}};
}

Eigen::MatrixXd correlation_of(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd inverse_deviations = covariance.diagonal().cwiseSqrt().cwiseInverse();
  return inverse_deviations.asDiagonal() * covariance * inverse_deviations.asDiagonal();
}

/// Replaces what the normal distribution says of the posterior by samples of it.
void take_samples(const ObservedModel& model, const InverseProblem& problem, const GaussianPosterior& posterior,
                  int samples, Calibration& found) {
  const auto size = static_cast<int>(model.size());
  EnsembleOptions options;
  options.walkers = std::max(4 * size, 20);
  options.steps = (samples + options.walkers - 1) / options.walkers;
  options.burn_in = options.steps / 2;
  const auto ensemble =
      sample_density([&](const Eigen::VectorXd& scores) { return log_density(problem, posterior, scores); },
                     posterior.mode, posterior.covariance, options);
  found.independent_samples = static_cast<double>(ensemble.samples.cols()) / ensemble.autocorrelation_time;

  for (Eigen::Index c = 0; c < model.size(); ++c) {
    const Eigen::VectorXd scores = ensemble.samples.row(c);
    const auto [median, interval] = spread_of(scores);
    const double deviation =
        std::sqrt((scores.array() - scores.mean()).square().sum() / static_cast<double>(scores.size() - 1));
    found.estimates[static_cast<std::size_t>(c)] = estimate_of(model.components()[static_cast<std::size_t>(c)], median,
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
  for (std::size_t i = 0; i < found.predictions.size(); ++i) {
    found.predictions[i].interval = spread_of(predictions.row(static_cast<Eigen::Index>(i))).interval;
  }
}

}  // namespace

Calibration calibrate(const std::vector<ObservedComposite>& composites, const std::vector<Unknown>& unknowns,
                      const std::vector<Observation>& observations, const CalibrationOptions& options) {
  const ObservedModel model(composites, unknowns, observations);
  Eigen::MatrixXd curvature = Eigen::MatrixXd::Zero(model.unknowns().curvature().rows(), model.size());
  curvature.leftCols(model.unknowns().size()) = model.unknowns().curvature();
  const InverseProblem problem = {
      .observations = static_cast<Eigen::Index>(observations.size()),
      .deviations = [&model](const Eigen::VectorXd& scores) { return model.deviations(scores); },
      .jacobian = [&model](const Eigen::VectorXd& scores) { return model.jacobian(scores); },
      .curvature = std::move(curvature)};
  const auto posterior = find_posterior(problem, options.noise);

  Calibration found = {.estimates = normal_estimates(model, posterior),
                       .correlation = correlation_of(posterior.covariance),
                       .predictions = normal_predictions(model, posterior),
                       .materials = model.unknowns().materials_at(posterior.mode),
                       .noise = posterior.noise,
                       .misfit = posterior.misfit,
                       .determined = posterior.determined,
                       .has_converged = posterior.has_converged};
  if (options.samples > 0) take_samples(model, problem, posterior, options.samples, found);
  found.warnings = warnings_on_coverage(model, posterior.mode, found.estimates);
  return found;
}

}  // namespace breccia
