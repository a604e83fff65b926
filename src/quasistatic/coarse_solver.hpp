#pragma once

#include <vector>

#include <Eigen/Dense>

#include "petsc_handle.hpp"

namespace breccia::quasistatic {

/// A sparse symmetric positive definite matrix, the sum of small ones, and its Cholesky factors (MUMPS).
class CoarseSolver {
 public:
  /// Where a small matrix is to be added; -1 for rows and columns to be left out.
  struct Part {
    std::vector<int> unknowns;
    const Eigen::MatrixXd* matrix;
  };

  /// Unknowns that nothing stiffens get stiffness_of_held. Throws NumericalError when the factors cannot be made, for
  /// want of memory or because the matrix is not positive definite; so does solve().
  CoarseSolver(int unknowns, const std::vector<Part>& parts, double stiffness_of_held);

  void solve(const std::vector<double>& right, std::vector<double>& solution) const;

 private:
  Matrix matrix_;
  LinearSolver solver_;
};

}  // namespace breccia::quasistatic
