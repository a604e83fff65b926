#pragma once

#include <vector>

#include <Eigen/Core>

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// Moduli [Pa], all sampled at the same times [s].
struct SampledModuli {
  Eigen::VectorXd times;
  std::vector<Eigen::VectorXd> moduli;
};

/// Fits of non-negative series with common relaxation times to several moduli (theory, Eq. 24): the strengths of each
/// series minimise the sum of the weighted squares of its relative deviations from the modulus.
class CommonTimesFit {
 public:
  /// Each sample has a weight of 1 until set_weights() is called.
  explicit CommonTimesFit(SampledModuli samples);

  [[nodiscard]] Eigen::Index deviations_count() const;
  void set_weights(const Eigen::VectorXd& weights) { roots_of_weights_ = weights.cwiseSqrt(); }

  /// Strengths of the terms, and the equilibrium modulus as the last row; a column for each modulus [Pa].
  [[nodiscard]] Eigen::MatrixXd strengths(const Eigen::VectorXd& relaxation_times) const;
  /// Unweighted relative deviations of the series with these strengths, one modulus after the other.
  [[nodiscard]] Eigen::VectorXd deviations(const Eigen::VectorXd& relaxation_times,
                                           const Eigen::MatrixXd& strengths) const;
  /// Moves the logarithms of relaxation times [ln s], within bounds, so as to minimise the sum of weighted squares, by
  /// variable projection (theory, Eq. 33c).
  void move(Eigen::VectorXd& logarithms, double least, double most, int most_evaluations) const;

  /// The series of each modulus, without terms of no strength.
  [[nodiscard]] std::vector<PronySeries> series(const Eigen::VectorXd& relaxation_times) const;

 private:
  [[nodiscard]] Eigen::MatrixXd decays(const Eigen::VectorXd& relaxation_times) const;
  [[nodiscard]] Eigen::MatrixXd weighted_columns(const Eigen::MatrixXd& decays, std::size_t modulus) const;
  [[nodiscard]] Eigen::VectorXd weights_of(std::size_t modulus) const;
  [[nodiscard]] Eigen::MatrixXd projected_derivatives(const Eigen::VectorXd& relaxation_times) const;

  SampledModuli samples_;
  Eigen::VectorXd roots_of_weights_;
};

}  // namespace breccia
