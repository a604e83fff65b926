#pragma once

#include <string>
#include <vector>

#include "elastic_solver.hpp"

namespace breccia::quasistatic {

enum class Preconditioner {
  factors,   ///< sparse Cholesky factors (MUMPS)
  multigrid  ///< algebraic, with the rigid motions (GAMG)
};

/// Conjugate gradients on the assembled stiffness matrix, over all processes.
class AssembledSolver final : public ElasticSolver {
 public:
  AssembledSolver(const ElasticBox& box, const LinearOptions& options, Preconditioner preconditioner);

  void refresh() override;

  void save_preparation(StateWriter& state, const std::string& group) const override;
  void restore_preparation(const StateReader& state, const std::string& group) override;

 private:
  void take(std::span<const Moduli> moduli) override;
  /// Refreshes the preconditioner when that of earlier moduli has become poor.
  End iterate(const Field& forces, Field& displacement) override;
  void set_up();
  /// What to say when the preconditioner cannot be made.
  [[nodiscard]] const char* failure() const noexcept;
  static PetscErrorCode is_converged(KSP solver, PetscInt iteration, PetscReal residual, KSPConvergedReason* reason,
                                     void* self);
  [[nodiscard]] bool try_to_solve(const Field& forces, Field& displacement, int most_iterations);

  Preconditioner preconditioner_;
  Matrix matrix_;
  LinearSolver solver_;
  std::vector<Moduli> moduli_;           ///< the present ones, by material
  std::vector<Moduli> prepared_moduli_;  ///< those of the preconditioner
  int fresh_iterations_ = 0;             ///< with a preconditioner for the same moduli; 0 before the first
  bool is_fresh_ = false;                ///< whether the preconditioner is that of the present moduli
};

}  // namespace breccia::quasistatic
