#pragma once

#include <functional>

#include <Eigen/Core>

#include "breccia/assessment/calibrate.hpp"

namespace breccia {

/// Deviations r(x) of predictions from data in standard deviations, for unknowns x that are normal about zero a priori;
/// in addition, the components of C x are normal with a deviation that is not known.
struct InverseProblem {
  Eigen::Index observations = 0;
  std::function<Eigen::VectorXd(const Eigen::VectorXd& x)> deviations;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& x)> jacobian;  ///< observations x unknowns
  Eigen::VectorXd prior_deviations;                                   ///< standard deviation of each unknown a priori
  Eigen::MatrixXd curvature;  ///< C, with a column for each unknown and any number of rows
};

/// The posterior of the unknowns as a normal distribution about its mode (Laplace's approximation).
struct GaussianPosterior {
  Eigen::VectorXd mode;
  Eigen::MatrixXd covariance;
  Eigen::VectorXd prior_variances;  ///< of each unknown, the curvature included
  double noise = 1.0;               ///< factor of the standard deviations of the data [-]
  double curvature_weight = 0.0;    ///< inverse square of the deviation of C x
  double misfit = 0.0;              ///< sum of squares of the deviations, in units of noise^2
  double determined = 0.0;          ///< number of unknowns that the data determine, trace(J (J'J + P)^-1 J')
  bool has_converged = false;
};

/// The logarithm of the density of the posterior at x, up to a constant, with the noise and the curvature of a
/// posterior that was found.
double log_density(const InverseProblem& problem, const GaussianPosterior& found, const Eigen::VectorXd& x);

/// Finds the posterior. The deviation of C x, and the factor of the noise where it is not known, maximise the evidence
/// (MacKay, Neural Computation 4, 415, 1992; theory, Eqs. 81 and 82). The mode is sought by the method of Levenberg and
/// Marquardt from x = 0.
GaussianPosterior find_posterior(const InverseProblem& problem, Noise noise);

}  // namespace breccia
