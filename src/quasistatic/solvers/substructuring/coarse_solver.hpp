#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Dense>

#include "quasistatic/operator/shared_values.hpp"
#include "quasistatic/solvers/direct/cholesky_factors.hpp"

namespace breccia::quasistatic {

/// The coarse problem of the preconditioner: a sparse symmetric positive definite matrix, summed from the small
/// matrices of the blocks of all processes, and its Cholesky factors (MUMPS), distributed over the processes.
class CoarseSolver {
 public:
  /// A small matrix, and the unknown of each of its rows and columns; -1 leaves a row and column out.
  struct Part {
    std::vector<int> unknowns;
    const Eigen::MatrixXd* matrix;
  };

  /// The first `owned` unknowns of this process are its own; the remaining ones are copies of unknowns of other
  /// processes. Unknowns to which no small matrix contributes get the diagonal entry `stiffness_of_held`. Throws
  /// NumericalError when the matrix cannot be factorised, because memory runs out or it is not positive definite; so
  /// does solve().
  CoarseSolver(int owned, int unknowns, const SharedValues& shared, const std::vector<Part>& parts,
               double stiffness_of_held);

  /// Finds the unknowns of this process, from the right sides of the unknowns that it owns.
  void solve(const std::vector<double>& right, std::vector<double>& solution) const;

  /// Number of unknowns, of all processes.
  [[nodiscard]] std::int64_t unknowns() const { return factors_.unknowns(); }

 private:
  CholeskyFactors factors_;
};

}  // namespace breccia::quasistatic
