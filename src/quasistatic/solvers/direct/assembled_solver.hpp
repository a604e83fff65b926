#pragma once

#include <exception>
#include <string>
#include <vector>

#include "quasistatic/solvers/elastic_solver.hpp"

namespace breccia::quasistatic {

enum class Preconditioner {
  factors,   ///< sparse Cholesky factors (MUMPS)
  multigrid  ///< smoothed aggregation algebraic multigrid with the rigid motions (GAMG)
};

/// Conjugate gradients on the assembled stiffness matrix, over all processes.
template <int dim>
class AssembledSolver final : public ElasticSolver<dim> {
 public:
  AssembledSolver(const ElasticOperator<dim>& elastic_operator, const LinearOptions& options,
                  Preconditioner preconditioner);

  void update_preconditioner() override;

  void save_preconditioner(StateWriter& state, const std::string& group) const override;
  void restore_preconditioner(const StateReader& state, const std::string& group) override;

 private:
  void update_stiffness(std::span<const Moduli> moduli) override;
  /// Solves with the preconditioner of earlier moduli and makes a new one when that takes too many iterations.
  typename ElasticSolver<dim>::Convergence iterate(NodalVector on_nodes, Displacement& displacement) override;
  void set_up();
  /// Message of the error when the preconditioner cannot be made.
  [[nodiscard]] const char* failure() const noexcept;
  static PetscErrorCode is_converged(KSP solver, PetscInt iteration, PetscReal residual, KSPConvergedReason* reason,
                                     void* self);
  [[nodiscard]] bool try_to_solve(Vec on_nodes, Displacement& displacement, int most_iterations);

  Preconditioner preconditioner_;
  Matrix matrix_;
  LinearSolver solver_;
  std::vector<Moduli> prepared_moduli_;  ///< moduli for which the preconditioner was made
  int fresh_iterations_ = 0;             ///< iterations with a preconditioner of the present moduli; 0 before any
  std::exception_ptr ended_by_;          ///< exception of an iteration that has ended the solution
  bool is_fresh_ = false;                ///< whether the preconditioner was made for the present moduli
};

extern template class AssembledSolver<2>;
extern template class AssembledSolver<3>;

}  // namespace breccia::quasistatic
