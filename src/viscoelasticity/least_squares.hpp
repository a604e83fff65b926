#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

namespace breccia {

// Least squares by Eigen, whose decompositions take seconds to compile and are therefore compiled in one source.

/// The x that minimises |A x - b|, by orthogonal factors with column pivoting.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// A matrix of orthonormal columns that span the columns of a matrix: it has the same number of rows, and as many
/// columns as the rank.
Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns);

/// Diagonal of (J'J)^-1, the variances of the unknowns for deviations of unit variance. Returns nothing where J'J is
/// singular.
std::optional<Eigen::VectorXd> variances(const Eigen::MatrixXd& jacobian);

/// A problem of nonlinear least squares: the deviations f(x), whose sum of squares is to be minimised.
struct NonlinearLeastSquares {
  Eigen::Index values;                                                           ///< number of deviations
  std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& f)> deviations;  ///< sets f(x), which has its size
  std::function<void(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian)>
      jacobian;  ///< sets df_i / dx_j, values x unknowns
};

/// Criteria by which a search ends.
struct SearchLimits {
  double relative_step = 0.0;      ///< relative size of a step of x
  double relative_decrease = 0.0;  ///< relative decrease of the sum of squares
  int most_evaluations = 400;      ///< largest number of evaluations of the deviations
};

/// Moves x to the minimum of the sum of squares by the method of Levenberg and Marquardt. Returns whether the search
/// ended within the allowed number of evaluations; x is the best one found in any case.
[[nodiscard]] bool search_least_squares(const NonlinearLeastSquares& problem, const SearchLimits& limits,
                                        Eigen::VectorXd& x);

}  // namespace breccia
