#pragma once

#include <functional>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace breccia::films {

/// Solves linear systems with one symmetric, quasi-definite matrix after the other, all with the same pattern. All
/// processes of the group call the functions together; the matrix is on the first one.
class SymmetricSolver {
 public:
  using Sparse = Eigen::SparseMatrix<double>;

  SymmetricSolver() = default;
  virtual ~SymmetricSolver() = default;
  SymmetricSolver(const SymmetricSolver&) = delete;
  SymmetricSolver& operator=(const SymmetricSolver&) = delete;
  SymmetricSolver(SymmetricSolver&&) = delete;
  SymmetricSolver& operator=(SymmetricSolver&&) = delete;

  /// Factorises the matrix whose lower triangle a function returns; the first process alone calls it. Throws
  /// NumericalError when that fails.
  virtual void factorise(const std::function<Sparse()>& lower_triangle) = 0;
  /// Solves for a right side, which every process gives, like the solution. Throws NumericalError when the residual
  /// stays large.
  [[nodiscard]] virtual Eigen::VectorXd solve(const Eigen::VectorXd& right_side) = 0;
  /// Residual after the last solve, relative to the right side in the Euclidean norm [-].
  [[nodiscard]] virtual double residual() const noexcept = 0;
  /// Number of iterations of the last solve; 0 of a direct solver.
  [[nodiscard]] virtual int iterations() const noexcept = 0;
};

}  // namespace breccia::films
