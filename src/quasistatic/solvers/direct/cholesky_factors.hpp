#pragma once

#include <cstdint>

#include "quasistatic/operator/matrix_entries.hpp"
#include "quasistatic/operator/petsc_handle.hpp"

namespace breccia::quasistatic {

/// The Cholesky factors (MUMPS) of a sparse symmetric positive definite matrix, distributed over the processes.
class CholeskyFactors {
 public:
  /// The number of the first of the `owned` unknowns of this process among those of all processes.
  [[nodiscard]] static int first_of_process(int owned);

  /// This process has `owned` rows. The entries of one triangle that all processes give, numbered among all rows, are
  /// added up. `what` names the matrix in messages. Throws NumericalError when it cannot be factorised, because memory
  /// runs out or it is not positive definite; so does solve().
  CholeskyFactors(int owned, MatrixEntries entries, const char* what);

  /// Finds the unknowns of this process, from their right sides.
  void solve(const double* right, double* solution) const;

  /// Number of unknowns, of all processes.
  [[nodiscard]] std::int64_t unknowns() const;

 private:
  void require_no_breakdown() const;

  int owned_;
  const char* what_;
  Matrix matrix_;
  LinearSolver solver_;
};

}  // namespace breccia::quasistatic
