#include "assessment/gaussian_posterior.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "viscoelasticity/least_squares.hpp"

namespace breccia {
namespace {

/// The search for a posterior, one choice of the noise and of the weight of the curvature after the other.
class PosteriorSearch {
 public:
  PosteriorSearch(const InverseProblem& problem, Noise noise)
      : problem_(problem), noise_(noise), unknowns_(problem.curvature.cols()), rows_(problem.curvature.rows()) {
    found_.mode = Eigen::VectorXd::Zero(unknowns_);
    found_.curvature_weight = rows_ > 0 ? 1.0 : 0.0;
  }

  GaussianPosterior find() {
    constexpr int most = 100;
    constexpr double small = 1e-3;
    for (int i = 0; i < most; ++i) {
      move_to_mode();
      linearise();
      if (update() < small) {
        found_.has_converged = found_.has_converged && i + 1 < most;
        break;
      }
    }
    return std::move(found_);
  }

 private:
  /// The square root of the precision of the prior, by rows: x, then the weighted curvature.
  [[nodiscard]] Eigen::MatrixXd prior_rows() const {
    Eigen::MatrixXd rows(unknowns_ + rows_, unknowns_);
    rows.topRows(unknowns_).setIdentity();
    rows.bottomRows(rows_) = std::sqrt(found_.curvature_weight) * problem_.curvature;
    return rows;
  }

  void move_to_mode() {
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
    const SearchLimits limits = {.relative_step = 1e-7, .relative_decrease = 1e-10};
    found_.has_converged = search_least_squares(squares, limits, found_.mode);
  }

  void linearise() {
    const Eigen::MatrixXd jacobian = problem_.jacobian(found_.mode) / found_.noise;
    const Eigen::MatrixXd prior = prior_rows();
    const Eigen::MatrixXd of_data = jacobian.transpose() * jacobian, of_prior = prior.transpose() * prior;
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(unknowns_, unknowns_);
    found_.covariance = (of_data + of_prior).ldlt().solve(identity);
    prior_covariance_ = of_prior.ldlt().solve(identity);
    found_.prior_variances = prior_covariance_.diagonal();
    found_.misfit = (problem_.deviations(found_.mode) / found_.noise).squaredNorm();
    found_.determined = (of_data * found_.covariance).trace();
  }

  /// Takes the noise and the weight that maximise the evidence for the present linearisation. Returns the largest
  /// relative change.
  double update() {
    double change = 0.0;
    if (noise_ == Noise::relative) {
      const double free = std::max(static_cast<double>(problem_.observations) - found_.determined, 1.0);
      constexpr double least = 1e-9;  // of data without noise
      const double factor = std::sqrt(std::max(found_.misfit / free, least * least));
      found_.noise *= factor;
      change = std::max(change, std::abs(factor - 1.0));
    }
    if (rows_ > 0) {
      constexpr double softest = 1e-4, stiffest = 1e8;
      const auto& c = problem_.curvature;
      const double taken =
          (c * prior_covariance_ * c.transpose()).trace() - (c * found_.covariance * c.transpose()).trace();
      const double weight =
          std::clamp(found_.curvature_weight * taken / (c * found_.mode).squaredNorm(), softest, stiffest);
      change = std::max(change, std::abs(weight / found_.curvature_weight - 1.0));
      found_.curvature_weight = weight;
    }
    return change;
  }

  const InverseProblem& problem_;
  Noise noise_;
  Eigen::Index unknowns_, rows_;
  Eigen::MatrixXd prior_covariance_;
  GaussianPosterior found_;
};

}  // namespace

GaussianPosterior find_posterior(const InverseProblem& problem, Noise noise) {
  return PosteriorSearch(problem, noise).find();
}

}  // namespace breccia
