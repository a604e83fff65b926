#pragma once

#include <functional>

#include <Eigen/Core>

namespace breccia::films {

using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

struct KrylovSolution {
  Eigen::VectorXd solution;
  double residual = 0.0;  ///< relative to the right side in the Euclidean norm [-]
  int iterations = 0;
};

/// Solves A x = b by flexible generalised minimal residuals (Saad 1993), with a preconditioner on the right: an
/// approximate inverse of A, of any symmetry, which need not be linear to rounding. Each iteration keeps two vectors;
/// after 50 they are started anew from the residual. Ends at a relative residual, after 150 iterations, or where a
/// residual is not finite.
[[nodiscard]] KrylovSolution minimal_residuals(const LinearMap& matrix, const LinearMap& preconditioner,
                                               const Eigen::VectorXd& right_side, double tolerance);

}  // namespace breccia::films
