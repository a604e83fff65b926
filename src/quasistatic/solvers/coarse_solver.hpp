#pragma once

#include <vector>

#include <Eigen/Dense>

#include "operator/petsc_handle.hpp"

namespace breccia::quasistatic {

/// The coarse problem of the preconditioner: a sparse symmetric positive definite matrix, summed from the small
/// matrices of the blocks, and its Cholesky factors (MUMPS).
class CoarseSolver {
 public:
  /// A small matrix, and the unknown of each of its rows and columns; -1 leaves a row and column out.
  struct Part {
    std::vector<int> unknowns;
    const Eigen::MatrixXd* matrix;
  };

  /// Unknowns to which no small matrix contributes get the diagonal entry `stiffness_of_held`. Throws NumericalError
  /// when the matrix cannot be factorised, because memory runs out or it is not positive definite; so does solve().
  CoarseSolver(int unknowns, const std::vector<Part>& parts, double stiffness_of_held);

  void solve(const std::vector<double>& right, std::vector<double>& solution) const;

 private:
  Matrix matrix_;
  LinearSolver solver_;
};

}  // namespace breccia::quasistatic
