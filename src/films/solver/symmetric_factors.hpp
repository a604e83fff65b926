#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <dmumps_c.h>

#include "films/solver/factor_directory.hpp"

namespace breccia::films {

/// The sparse factors L D L^T of one symmetric matrix after the other, all with the same pattern, by MUMPS (Amestoy,
/// Duff, L'Excellent and Koster 2001) in the order of elimination_order(). Factors that take more than the given memory
/// are kept in files (FactorDirectory) until the end. All processes of the group call the functions together, and each
/// has a part of the factors; the matrix is on the first one.
class SymmetricFactors {
 public:
  using Sparse = Eigen::SparseMatrix<double>;

  /// `memory` [B] is the largest memory of a process for the factors and their workspace.
  explicit SymmetricFactors(double memory) : memory_(memory) {}

  /// Factorises the matrix whose lower triangle a function returns; the first process alone calls it. Throws
  /// NumericalError when that fails, and InputError when files are needed and there is no directory for them.
  void factorise(const std::function<Sparse()>& lower_triangle);
  /// Solves by the factors, with a step of refinement. Every process gives the right side and gets the solution. Throws
  /// NumericalError when the residual is large all the same.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_side);

  /// Residual after the last solve, relative to the right side in the Euclidean norm [-].
  [[nodiscard]] double residual() const noexcept { return residual_; }
  [[nodiscard]] bool are_in_files() const;

 private:
  /// Ends an instance of MUMPS.
  struct InstanceDeleter {
    void operator()(DMUMPS_STRUC_C* instance) const;
  };

  /// Whether the matrix is on this process.
  [[nodiscard]] static bool has_matrix() noexcept;
  void analyse();
  [[nodiscard]] Eigen::VectorXd solve_once(const Eigen::VectorXd& right_side) const;

  double memory_;
  Sparse matrix_;                             ///< matrix, on the first process like the lists of its entries
  std::optional<FactorDirectory> directory_;  ///< directory of the files, which MUMPS closes before it is removed
  std::vector<int> rows_, columns_;           ///< rows and columns of the entries, from 1
  std::unique_ptr<DMUMPS_STRUC_C, InstanceDeleter> mumps_;
  double residual_ = 0.0;
};

}  // namespace breccia::films
