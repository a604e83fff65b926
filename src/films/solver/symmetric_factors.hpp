#pragma once

#include <optional>

#include "films/solver/factor_directory.hpp"
#include "films/solver/mumps_instance.hpp"
#include "films/solver/symmetric_solver.hpp"

namespace breccia::films {

/// Solves by factors L D L^T with all their digits. Factors that take more than the given memory are kept in files
/// (FactorDirectory) until the end.
class SymmetricFactors final : public SymmetricSolver {
 public:
  /// `memory` [B] is the largest memory of a process for the factors and their workspace.
  explicit SymmetricFactors(double memory) : memory_(memory) {}

  /// Throws InputError, too, when files are needed and there is no directory for them.
  void factorise(std::function<Sparse()> lower_triangle) override;
  /// Solves with a step of refinement.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_side) override;
  [[nodiscard]] bool are_in_files() const { return mumps_->keeps_in_files(); }

 private:
  [[nodiscard]] Eigen::VectorXd solve_once(const Eigen::VectorXd& right_side) const;

  double memory_;
  Sparse matrix_;                             ///< matrix, on the first process
  std::optional<FactorDirectory> directory_;  ///< directory of the files, which MUMPS closes before it is removed
  std::optional<MumpsInstance<double>> mumps_;
};

}  // namespace breccia::films
