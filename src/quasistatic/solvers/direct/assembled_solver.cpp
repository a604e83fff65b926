#include "quasistatic/solvers/direct/assembled_solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <utility>

#include "quasistatic/solvers/direct/breakdown.hpp"
#include "quasistatic/solvers/direct/solver_options.hpp"
#include "quasistatic/solvers/direct/sparse_factors.hpp"

namespace breccia::quasistatic {
namespace {

/// Prefix of the PETSc options of this solver, by which users replace them on the command line.
constexpr const char* options_prefix = "quasistatic_";

}  // namespace

template <int dim>
AssembledSolver<dim>::AssembledSolver(const ElasticOperator<dim>& elastic_operator, const LinearOptions& options,
                                      Preconditioner preconditioner)
    : ElasticSolver<dim>(elastic_operator, options, preconditioner == Preconditioner::factors),
      preconditioner_(preconditioner),
      matrix_(elastic_operator.make_matrix()) {}

template <int dim>
void AssembledSolver<dim>::set_up() {
  constexpr const char* what = "setting up the linear solver";
  check(KSPCreate(PETSC_COMM_WORLD, solver_.put()), what);
  check(KSPSetOptionsPrefix(solver_.get(), options_prefix), what);
  check(KSPSetType(solver_.get(), KSPCG), what);
  check(KSPSetNormType(solver_.get(), KSP_NORM_UNPRECONDITIONED), what);
  check(KSPSetInitialGuessNonzero(solver_.get(), PETSC_TRUE), what);
  check(KSPSetOperators(solver_.get(), matrix_.get(), matrix_.get()), what);
  check(KSPSetConvergenceTest(solver_.get(), is_converged, this, nullptr), what);
  PC preconditioner = nullptr;
  check(KSPGetPC(solver_.get(), &preconditioner), what);
  if (preconditioner_ == Preconditioner::factors) {
    check(PCSetType(preconditioner, PCCHOLESKY), what);
    check(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS), what);
  } else {
    check(PCSetType(preconditioner, PCGAMG), what);
    this->elastic_operator().attach_rigid_motions(matrix_.get());
    set_default_option(options_prefix, "pc_gamg_threshold", "0.02");
    set_default_option(options_prefix, "mg_levels_ksp_max_it", "4");
  }
  check(KSPSetFromOptions(solver_.get()), what);
}

template <int dim>
const char* AssembledSolver<dim>::failure() const noexcept {
  return preconditioner_ == Preconditioner::factors
             ? "quasi-static solver: the stiffness matrix cannot be factorised: memory may have run out (fewer cells "
               "take less, and so does tests.quasistatic.linear = \"iterative\"), or a modulus is zero"
             : "quasi-static solver: multigrid fails on the stiffness matrix: a modulus may be zero";
}

template <int dim>
void AssembledSolver<dim>::update_stiffness(std::span<const Moduli> moduli) {
  this->elastic_operator().assemble(moduli, matrix_.get());
  is_fresh_ = false;
}

template <int dim>
void AssembledSolver<dim>::update_preconditioner() {
  if (is_fresh_) return;
  if (solver_.get() == nullptr) set_up();
  check(KSPSetReusePreconditioner(solver_.get(), PETSC_FALSE), "factorising");
  check(KSPSetOperators(solver_.get(), matrix_.get(), matrix_.get()), "factorising");
  set_up_with_room(solver_.get(),
                   this->effort().is_direct ? "factorising the stiffness matrix" : "setting up multigrid");
  require_no_breakdown(solver_.get(), failure());
  check(KSPSetReusePreconditioner(solver_.get(), PETSC_TRUE), "factorising");
  this->count_factorisation();
  prepared_moduli_ = this->moduli();
  is_fresh_ = true;
}

template <int dim>
void AssembledSolver<dim>::save_preconditioner(StateWriter& state, const std::string& group) const {
  std::vector<double> bulk, shear;
  for (const auto& moduli : prepared_moduli_) {
    bulk.push_back(moduli.bulk);
    shear.push_back(moduli.shear);
  }
  state.write(group + "/bulk_Pa", bulk);
  state.write(group + "/shear_Pa", shear);
  state.write(group + "/iterations", std::int64_t{fresh_iterations_});
}

template <int dim>
void AssembledSolver<dim>::restore_preconditioner(const StateReader& state, const std::string& group) {
  const auto bulk = state.numbers(group + "/bulk_Pa");
  const auto shear = state.numbers(group + "/shear_Pa", bulk.size());
  std::vector<Moduli> moduli;
  for (std::size_t m = 0; m < bulk.size(); ++m) moduli.push_back({.bulk = bulk[m], .shear = shear[m]});
  fresh_iterations_ = static_cast<int>(state.integer(group + "/iterations"));
  if (moduli.empty()) return;
  this->set_moduli(moduli);
  update_preconditioner();
}

template <int dim>
PetscErrorCode AssembledSolver<dim>::is_converged(KSP solver, PetscInt /*iteration*/, PetscReal residual,
                                                  KSPConvergedReason* reason, void* self) {
  auto& that = *static_cast<AssembledSolver*>(self);
  *reason = KSP_CONVERGED_ITERATING;
  if (!std::isfinite(residual)) {
    *reason = KSP_DIVERGED_NANORINF;
  } else if (that.is_small(residual, 0.0)) {
    *reason = KSP_CONVERGED_RTOL;
  } else {
    Vec displacement = nullptr;
    PetscReal largest = 0.0;
    PetscCall(KSPBuildSolution(solver, nullptr, &displacement));
    PetscCall(VecNorm(displacement, NORM_INFINITY, &largest));
    if (that.is_small(residual, largest)) *reason = KSP_CONVERGED_ATOL;
  }
  if (*reason != KSP_CONVERGED_ITERATING) return 0;
  // No exception may pass through PETSc.
  try {
    that.look_in_iteration();
  } catch (...) {
    that.ended_by_ = std::current_exception();
    *reason = KSP_DIVERGED_ITS;
  }
  return 0;
}

template <int dim>
bool AssembledSolver<dim>::try_to_solve(Vec on_nodes, Displacement& displacement, int most_iterations) {
  constexpr const char* what = "solving for the displacements";
  check(KSPSetTolerances(solver_.get(), PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, most_iterations), what);
  check(KSPSolve(solver_.get(), on_nodes, displacement.fluctuation()), what);
  if (ended_by_) std::rethrow_exception(std::exchange(ended_by_, nullptr));
  int iterations = 0;
  check(KSPGetIterationNumber(solver_.get(), &iterations), what);
  this->count_iterations(iterations);
  if (is_fresh_) fresh_iterations_ = std::max(1, iterations);
  return require_no_breakdown(solver_.get(), failure()) > 0;
}

template <int dim>
typename ElasticSolver<dim>::Convergence AssembledSolver<dim>::iterate(NodalVector on_nodes,
                                                                       Displacement& displacement) {
  // Number of iterations with an old factorisation that cost about as much as a new one.
  constexpr int worth_a_factorisation = 8, many = 5000;
  if (fresh_iterations_ == 0) update_preconditioner();
  bool is_solved = !is_fresh_ && try_to_solve(on_nodes.get(), displacement, fresh_iterations_ + worth_a_factorisation);
  if (!is_solved) {
    update_preconditioner();
    is_solved = try_to_solve(on_nodes.get(), displacement, many);
  }
  double residual = 0.0;
  check(KSPGetResidualNorm(solver_.get(), &residual), "reading the residual");
  return {is_solved, residual};
}

template class AssembledSolver<2>;
template class AssembledSolver<3>;

}  // namespace breccia::quasistatic
