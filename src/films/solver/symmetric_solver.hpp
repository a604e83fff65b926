#pragma once

#include <functional>
#include <utility>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace breccia::films {

/// Solves linear systems with one symmetric, quasi-definite matrix after the other, all with the same pattern. All
/// processes of the group call the functions together; the matrix is on the first one.
class SymmetricSolver {
 public:
  using Sparse = Eigen::SparseMatrix<double>;

  /// What the last solve took.
  struct Effort {
    int factorisations = 0;  ///< number of those beyond the first one of the matrix
    int iterations = 0;
    double residual = 0.0;  ///< relative to the right side in the Euclidean norm [-]
  };

  SymmetricSolver() = default;
  virtual ~SymmetricSolver() = default;
  SymmetricSolver(const SymmetricSolver&) = delete;
  SymmetricSolver& operator=(const SymmetricSolver&) = delete;
  SymmetricSolver(SymmetricSolver&&) = delete;
  SymmetricSolver& operator=(SymmetricSolver&&) = delete;

  /// Factorises the matrix whose lower triangle a function returns; the first process alone calls it, later again if it
  /// must. Throws NumericalError when that fails.
  virtual void factorise(std::function<Sparse()> lower_triangle) = 0;
  /// Solves for a right side, which every process gives, like the solution. The solution depends on the matrix and the
  /// right side alone. Throws NumericalError when the residual stays large.
  [[nodiscard]] virtual Eigen::VectorXd solve(const Eigen::VectorXd& right_side) = 0;
  [[nodiscard]] const Effort& effort() const noexcept { return effort_; }

  /// Calls a function on all processes in every iteration of the solutions that follow; an exception that it throws, on
  /// all of them, ends the solution. Factors alone solve without iterations.
  void watch(std::function<void()> in_iteration) { in_iteration_ = std::move(in_iteration); }

 protected:
  Effort effort_;
  std::function<void()> in_iteration_ = [] {};
};

}  // namespace breccia::films
