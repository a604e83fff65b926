#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <petscmat.h>

namespace breccia::films {

/// The sparse factors L D L^T of one symmetric matrix after the other, all with the same pattern, by MUMPS through
/// PETSc. Each process works alone.
class SymmetricFactors {
 public:
  using Sparse = Eigen::SparseMatrix<double>;

  SymmetricFactors() = default;
  SymmetricFactors(const SymmetricFactors&) = delete;
  SymmetricFactors& operator=(const SymmetricFactors&) = delete;
  SymmetricFactors(SymmetricFactors&&) = delete;
  SymmetricFactors& operator=(SymmetricFactors&&) = delete;
  ~SymmetricFactors();

  /// Factorises a matrix of which the lower triangle is given. Throws NumericalError when that fails.
  void factorise(Sparse lower_triangle);
  /// Solves by the factors, with a step of refinement. Throws NumericalError when the residual is large all the same.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_side);

  /// Residual after the last solve, relative to the right side in the Euclidean norm [-].
  [[nodiscard]] double residual() const noexcept { return residual_; }
  /// Entries of the factors.
  [[nodiscard]] double entries() const;

 private:
  [[nodiscard]] Eigen::VectorXd solve_once(const Eigen::VectorXd& right_side) const;

  Sparse matrix_;
  Mat view_ = nullptr;  ///< of matrix_, whose columns are the rows of the upper triangle
  Mat factors_ = nullptr;
  double residual_ = 0.0;
};

}  // namespace breccia::films
