#pragma once

#include <optional>

#include "films/solver/minimal_residuals.hpp"
#include "films/solver/mumps_instance.hpp"
#include "films/solver/symmetric_factors.hpp"
#include "films/solver/symmetric_solver.hpp"

namespace breccia::films {

/// Solves by minimal residuals, preconditioned with factors in single precision whose blocks have low rank (theory,
/// section 17). In three dimensions they take a fraction of the memory and time of full ones. Where they do not serve,
/// factors with smaller errors do, and in the end full ones.
class CompressedFactors final : public SymmetricSolver {
 public:
  /// `memory` [B] is the largest memory of a process for full factors.
  explicit CompressedFactors(double memory) : full_(memory) {}

  void factorise(std::function<Sparse()> lower_triangle) override;
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_side) override;

 private:
  /// The accuracies of the factors, in the order in which they are tried: blocks of low rank with errors of 1e-3 and of
  /// 1e-5, and full blocks in double precision.
  enum class Accuracy { usual, fine, full };

  void make_factors(Accuracy accuracy);
  [[nodiscard]] KrylovSolution iterate(const Eigen::VectorXd& right_side);
  [[nodiscard]] Eigen::VectorXd solve_once(const Eigen::VectorXd& right_side) const;

  std::function<Sparse()> lower_triangle_;
  Sparse matrix_;          ///< matrix, on the first process, whose diagonal is scaled to 1 or -1
  Eigen::VectorXd scale_;  ///< factors of its rows and columns by which it is scaled
  std::optional<MumpsInstance<float>> mumps_;
  std::optional<Accuracy> made_;  ///< accuracy of the present factors of the matrix; nothing where these failed
  SymmetricFactors full_;
};

}  // namespace breccia::films
