#pragma once

#include <optional>
#include <vector>

#include "films/solver/mumps_instance.hpp"
#include "films/solver/symmetric_solver.hpp"

namespace breccia::films {

/// Solves by minimal residuals, preconditioned with factors in single precision whose blocks have low rank (theory,
/// section 17). In three dimensions they have two fifths of the entries of full ones, and take a tenth of the
/// operations, for a matrix of 300 000 rows.
class CompressedFactors final : public SymmetricSolver {
 public:
  void factorise(const std::function<Sparse()>& lower_triangle) override;
  /// Where the iterations do not converge, the factors are made anew with smaller errors, and these are kept for all
  /// further matrices.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_side) override;
  [[nodiscard]] double residual() const noexcept override { return residual_; }
  [[nodiscard]] int iterations() const noexcept override { return iterations_; }

 private:
  void make_factors();

  Sparse matrix_;          ///< matrix, on the first process, with a diagonal of 1 or -1
  Eigen::VectorXd scale_;  ///< factors of rows and columns with which the diagonal of the matrix becomes that
  std::optional<MumpsInstance<float>> mumps_;
  double error_ = 1e-3;  ///< error of the blocks of the factors
  double residual_ = 0.0;
  int iterations_ = 0;
};

}  // namespace breccia::films
