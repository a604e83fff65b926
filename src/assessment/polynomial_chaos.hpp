#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "breccia/assessment/assess.hpp"
#include "breccia/deckfile/uncertain_input.hpp"

namespace breccia {

/// Samples of outputs that depend on uncertain inputs.
struct SampledOutputs {
  Eigen::MatrixXd coordinates;      ///< of the inputs (inputs x samples)
  Eigen::MatrixXd values;           ///< of the outputs (outputs x samples)
  std::vector<std::size_t> groups;  ///< the group of each sample, from 0: samples of a group share an error
  /// Inputs that are the same for all samples of a group, by input.
  std::vector<bool> are_of_group;
};

/// The samples of a curve as polynomials follow them: the logarithms of moduli, phases as they are, an output for each
/// time or frequency. Samples of several boxes are grouped by these.
SampledOutputs followed_samples(const AssessmentDesign& design, const SampledCurve& curve);

/// Outputs as polynomials in uncertain inputs that do not depend on each other, in terms that are orthonormal under the
/// distributions of the inputs: Hermite's of a score, Legendre's of a uniform share, contrasts of choices (theory,
/// section 20). The coefficients are found by least squares; the degree, up to 10 in all and less in the inputs of
/// groups, is that with the least error in predicting samples of a group from all others.
class PolynomialChaos {
 public:
  PolynomialChaos(std::vector<UncertainInput> inputs, const SampledOutputs& samples);

  /// The outputs (outputs x points) at coordinates of the inputs (inputs x points).
  [[nodiscard]] Eigen::MatrixXd at(const Eigen::MatrixXd& coordinates) const;
  /// The variance of each output.
  [[nodiscard]] Eigen::VectorXd variances() const;
  /// The share of the variance of each output that an input causes alone, its first-order index (inputs x outputs).
  [[nodiscard]] Eigen::MatrixXd first_order() const;
  /// The share to which an input contributes, alone or with others, its total index (inputs x outputs).
  [[nodiscard]] Eigen::MatrixXd total() const;
  /// The mean square of the deviations in predicting the samples of a group from all others, of each output.
  [[nodiscard]] const Eigen::VectorXd& mean_square_errors() const noexcept { return mean_square_errors_; }
  [[nodiscard]] int degree() const noexcept { return degree_; }

 private:
  /// The function of each input that is a factor of a term, by input; 0 is the constant.
  using Term = std::vector<int>;

  /// The terms up to a degree in all inputs and in those of groups; empty where there are more than `most`.
  [[nodiscard]] std::vector<Term> terms_up_to(int degree, int degree_of_group, const std::vector<bool>& are_of_group,
                                              std::size_t most) const;
  [[nodiscard]] Eigen::MatrixXd functions_at(const std::vector<Term>& terms, const Eigen::MatrixXd& coordinates) const;
  /// The sum of the squared coefficients of the terms that a function of the term accepts, over the variance.
  template <class Accepts>
  [[nodiscard]] Eigen::RowVectorXd share_of(const Accepts& accepts) const;

  std::vector<UncertainInput> inputs_;
  std::vector<Term> terms_;
  Eigen::MatrixXd coefficients_;  ///< terms x outputs
  Eigen::VectorXd mean_square_errors_;
  int degree_ = 0;
};

}  // namespace breccia
