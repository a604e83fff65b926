#pragma once

#include <span>

#include "breccia/quasistatic/quasistatic_problem.hpp"

#include "elastic_box.hpp"

namespace breccia::quasistatic {

/// Solves K w = f for the displacements of the nodes, for one set of moduli after the other.
class ElasticSolver {
 public:
  ElasticSolver(const ElasticBox& box, const LinearOptions& options);

  /// Takes new moduli [Pa], by material. Factors of earlier moduli remain the preconditioner while they serve.
  void set_moduli(std::span<const Moduli> moduli);
  /// Factorises for the present moduli.
  void refresh();

  /// w such that K w = forces; on entry a guess. Refreshes the factors when they have become poor.
  /// Throws NumericalError when the iteration does not converge.
  void solve(const Field& forces, Field& displacement);

  [[nodiscard]] const LinearEffort& effort() const noexcept { return effort_; }

 private:
  void set_up();
  /// Is a residual small beside the load, or nothing but rounding of the forces?
  static PetscErrorCode is_converged(KSP solver, PetscInt iteration, PetscReal residual, KSPConvergedReason* reason,
                                     void* self);
  [[nodiscard]] bool try_to_solve(const Field& forces, Field& displacement, int most_iterations);

  const ElasticBox* box_;
  LinearOptions options_;
  Matrix matrix_;
  LinearSolver solver_;
  LinearEffort effort_;
  int fresh_iterations_ = 0;  ///< with factors of the same moduli; 0 before the first
  double rounding_ = 0.0;     ///< norm of the forces that displacements of order one leave by rounding alone
  double load_ = 0.0;         ///< norm of the forces of the present solve
  double given_ = 0.0;        ///< size of the displacements that the boundary gives: of a unit strain, or none
  bool is_fresh_ = false;     ///< whether the factors are those of the present moduli
};

}  // namespace breccia::quasistatic
