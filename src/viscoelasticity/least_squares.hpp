#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

namespace breccia {

// Least squares by Eigen. Its decompositions take seconds to compile, so they are compiled in one source.

/// The x that makes |A x - b| least, by orthogonal factors with column pivoting.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Orthonormal columns that span the columns of a matrix: as many rows as it has, as many columns as its rank.
Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns);

/// Diagonal of (J'J)^-1, the variances of the unknowns for deviations of unit variance. Returns nothing where J'J is
/// singular.
std::optional<Eigen::VectorXd> variances(const Eigen::MatrixXd& jacobian);

/// Deviations f(x), whose sum of squares is to be made least.
struct NonlinearLeastSquares {
  Eigen::Index values;                                                           ///< number of deviations
  std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& f)> deviations;  ///< sets f(x), which has its size
  std::function<void(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian)>
      jacobian;  ///< sets df_i / dx_j, values x unknowns
};

/// When a search ends.
struct SearchLimits {
  double relative_step = 0.0;      ///< of x
  double relative_decrease = 0.0;  ///< of the sum of squares
  int most_evaluations = 400;      ///< of the deviations
};

/// Moves x to the least sum of squares by the method of Levenberg and Marquardt. Returns whether it ended within the
/// evaluations allowed; x is the best found in any case.
[[nodiscard]] bool search_least_squares(const NonlinearLeastSquares& problem, const SearchLimits& limits,
                                        Eigen::VectorXd& x);

}  // namespace breccia
