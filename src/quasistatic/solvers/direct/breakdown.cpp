#include "quasistatic/solvers/direct/breakdown.hpp"

#include "breccia/error.hpp"

#include "quasistatic/operator/petsc_handle.hpp"

namespace breccia::quasistatic {

KSPConvergedReason require_no_breakdown(KSP solver, const char* cannot_be_prepared) {
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(solver, &reason), "reading how the linear solver ended");
  if (reason == KSP_DIVERGED_PC_FAILED || reason == KSP_DIVERGED_NANORINF) throw NumericalError(cannot_be_prepared);
  if (reason == KSP_DIVERGED_INDEFINITE_MAT || reason == KSP_DIVERGED_INDEFINITE_PC) {
    throw NumericalError(
        "quasi-static solver: the stiffness is not positive definite; a modulus of a material may vanish "
        "or be negative, or the contrast be beyond what numbers hold");
  }
  return reason;
}

}  // namespace breccia::quasistatic
