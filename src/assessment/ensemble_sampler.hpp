#pragma once

#include <cstdint>
#include <functional>

#include <Eigen/Core>

namespace breccia {

/// Settings of the sampler.
struct EnsembleOptions {
  int walkers = 0;  ///< even, at least twice the number of unknowns
  int steps = 0;    ///< moves of each walker whose positions are kept
  int burn_in = 0;  ///< moves of each walker before
  std::uint64_t seed = 1;
};

/// Samples of a density.
struct Ensemble {
  Eigen::MatrixXd samples;  ///< unknowns x (walkers * steps), all walkers of one step after the other
  double accepted = 0.0;    ///< share of the moves that were accepted [-]
  /// Number of independent samples: that of all over the largest autocorrelation time of an unknown, in steps (Sokal's
  /// estimate with a window of five times itself). NaN where there are less than fifty times as many steps, which are
  /// too few to estimate it.
  double independent_samples = 0.0;
};

/// Draws samples of a density from the logarithm of it, by an ensemble of walkers that stretch towards each other
/// (Goodman and Weare, Comm. Appl. Math. Comp. Sci. 5, 65, 2010); the two halves of the ensemble move in turn. The
/// walkers start from normal samples of a mean and a covariance, to be near the density. The same seed gives the same
/// samples.
Ensemble sample_density(const std::function<double(const Eigen::VectorXd& x)>& log_density, const Eigen::VectorXd& mean,
                        const Eigen::MatrixXd& covariance, const EnsembleOptions& options);

}  // namespace breccia
