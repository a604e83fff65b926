#include "assessment/gaussian_posterior.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Cholesky>

#include "viscoelasticity/least_squares.hpp"

namespace breccia {
namespace {

/// The search for a posterior: the mode for a choice of the noise and of the weight of the curvature, then the choice
/// that maximises the evidence of the problem linearised there, and so on.
class PosteriorSearch {
 public:
  PosteriorSearch(const InverseProblem& problem, Noise noise)
      : problem_(problem), noise_(noise), unknowns_(problem.curvature.cols()), rows_(problem.curvature.rows()) {
    found_.mode = Eigen::VectorXd::Zero(unknowns_);
    found_.curvature_weight = rows_ > 0 ? 1.0 : 0.0;
  }

  GaussianPosterior find() {
    constexpr int most = 30;
    for (int i = 0; i < most; ++i) {
      const bool is_mode = move_to_mode();
      linearise();
      const bool is_settled = maximise_evidence();
      found_.has_converged = is_mode && is_settled;
      if (is_settled) break;
    }
    return std::move(found_);
  }

 private:
  /// The square root of the precision of the prior, by rows: x, then the weighted curvature.
  [[nodiscard]] Eigen::MatrixXd prior_rows() const {
    Eigen::MatrixXd rows(unknowns_ + rows_, unknowns_);
    rows.topRows(unknowns_) = problem_.prior_deviations.cwiseInverse().asDiagonal();
    rows.bottomRows(rows_) = std::sqrt(found_.curvature_weight) * problem_.curvature;
    return rows;
  }

  /// Returns whether the search has ended at the mode.
  bool move_to_mode() {
    const Eigen::MatrixXd prior = prior_rows();
    const auto data = problem_.observations;
    const NonlinearLeastSquares squares = {.values = data + prior.rows(),
                                           .deviations =
                                               [&](const Eigen::VectorXd& x, Eigen::VectorXd& deviations) {
                                                 deviations.head(data) = problem_.deviations(x) / found_.noise;
                                                 deviations.tail(prior.rows()) = prior * x;
                                               },
                                           .jacobian =
                                               [&](const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian) {
                                                 jacobian.topRows(data) = problem_.jacobian(x) / found_.noise;
                                                 jacobian.bottomRows(prior.rows()) = prior;
                                               }};
    const SearchLimits limits = {.relative_step = 1e-4, .relative_decrease = 1e-4};
    return search_least_squares(squares, limits, found_.mode);
  }

  void linearise() {
    deviations_ = problem_.deviations(found_.mode);
    jacobian_ = problem_.jacobian(found_.mode);
    solve_linear();
  }

  /// The posterior of the linearised problem for the present noise and weight.
  void solve_linear() {
    const double noise2 = found_.noise * found_.noise;
    const Eigen::MatrixXd prior = prior_rows();
    const Eigen::MatrixXd of_data = jacobian_.transpose() * jacobian_ / noise2, of_prior = prior.transpose() * prior;
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(unknowns_, unknowns_);
    found_.covariance = (of_data + of_prior).ldlt().solve(identity);
    linear_mode_ = found_.covariance * (of_data * found_.mode - jacobian_.transpose() * deviations_ / noise2);
    prior_covariance_ = of_prior.ldlt().solve(identity);
    found_.prior_variances = prior_covariance_.diagonal();
    found_.misfit = (deviations_ + jacobian_ * (linear_mode_ - found_.mode)).squaredNorm() / noise2;
    found_.determined = (of_data * found_.covariance).trace();
  }

  /// Repeats MacKay's update of the noise and the weight until they settle, but not so far that the linearised problem
  /// would not hold any more. Where the weight turns back after its last change, both go half of the way, and from then
  /// on. Returns whether they have hardly changed: the noise by 2 %, the weight, on which less depends, by 8 %.
  bool maximise_evidence() {
    constexpr int most = 1000;
    constexpr double small = 1e-4, hardly = 0.02, far = std::numbers::ln2;
    const double noise = found_.noise, weight = found_.curvature_weight;
    const auto change = [](double now, double before) { return before > 0.0 ? std::log(now / before) : 0.0; };
    for (int i = 0; i < most; ++i) {
      const double noise_before = found_.noise, weight_before = found_.curvature_weight;
      update();
      solve_linear();
      if (std::abs(change(found_.noise, noise_before)) + std::abs(change(found_.curvature_weight, weight_before)) <
          small)
        break;
      if (std::abs(change(found_.noise, noise)) > far || std::abs(change(found_.curvature_weight, weight)) > 2.0 * far)
        break;
    }
    const double of_weight = change(found_.curvature_weight, weight);
    if (of_weight * last_change_ < 0.0) share_ *= 0.5;
    last_change_ = of_weight;
    const double of_noise = change(found_.noise, noise);
    const double step_of_noise = share_ * of_noise, step_of_weight = share_ * of_weight;
    found_.noise = noise * std::exp(step_of_noise);
    if (rows_ > 0) found_.curvature_weight = weight * std::exp(step_of_weight);
    solve_linear();
    // Of a search that goes back and forth, what it wants to change is larger than what it changes.
    constexpr double wanted = 10.0;
    return std::abs(step_of_noise) < hardly && std::abs(step_of_weight) < 4.0 * hardly &&
           std::abs(of_noise) < wanted * hardly && std::abs(of_weight) < 4.0 * wanted * hardly;
  }

  void update() {
    if (noise_ == Noise::relative) {
      constexpr double least = 1e-9;  // of data without noise
      const double free = std::max(static_cast<double>(problem_.observations) - found_.determined, 1.0);
      found_.noise = std::max(found_.noise * std::sqrt(found_.misfit / free), least);
    }
    if (rows_ > 0) {
      constexpr double softest = 1e-4, stiffest = 1e8;
      const auto& c = problem_.curvature;
      const double learned = (c * (prior_covariance_ - found_.covariance) * c.transpose()).trace();
      const double bent = (c * linear_mode_).squaredNorm();
      // Where no data reach a spectrum, they say nothing of its curvature.
      constexpr double rounding = 1e-12;
      if (learned > rounding && bent > rounding * rounding) {
        found_.curvature_weight = std::clamp(found_.curvature_weight * learned / bent, softest, stiffest);
      }
    }
  }

  const InverseProblem& problem_;
  Noise noise_;
  Eigen::Index unknowns_, rows_;
  Eigen::VectorXd deviations_, linear_mode_;  ///< at the mode, and the mode of the problem that is linearised there
  Eigen::MatrixXd jacobian_, prior_covariance_;
  double last_change_ = 0.0;  ///< of the logarithm of the weight
  double share_ = 1.0;        ///< share of a change of the noise and the weight that is taken
  GaussianPosterior found_;
};

}  // namespace

double log_density(const InverseProblem& problem, const GaussianPosterior& found, const Eigen::VectorXd& x) {
  const double misfit = (problem.deviations(x) / found.noise).squaredNorm();
  const double prior = x.cwiseQuotient(problem.prior_deviations).squaredNorm() +
                       found.curvature_weight * (problem.curvature * x).squaredNorm();
  const double logarithm = -0.5 * (misfit + prior);
  return std::isfinite(logarithm) ? logarithm : -std::numeric_limits<double>::infinity();
}

GaussianPosterior find_posterior(const InverseProblem& problem, Noise noise) {
  return PosteriorSearch(problem, noise).find();
}

}  // namespace breccia
