#include "solvers/sparse_factors.hpp"

#include <string_view>

#include "breccia/parallel/session.hpp"

namespace breccia::quasistatic {
namespace {

using parallel::check;

/// The factors of the preconditioner of a solver; null unless they are those of MUMPS.
Mat factors_of(KSP solver, const char* what) {
  PC preconditioner = nullptr;
  check(KSPGetPC(solver, &preconditioner), what);
  PetscBool is_cholesky = PETSC_FALSE;
  check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(preconditioner), PCCHOLESKY, &is_cholesky), what);
  if (is_cholesky != PETSC_TRUE) return nullptr;
  MatSolverType package = nullptr;
  check(PCFactorGetMatSolverType(preconditioner, &package), what);
  if (package == nullptr || std::string_view(package) != MATSOLVERMUMPS) return nullptr;
  Mat factors = nullptr;
  check(PCFactorSetUpMatSolverType(preconditioner), what);
  check(PCFactorGetMatrix(preconditioner, &factors), what);
  return factors;
}

/// Whether MUMPS has stopped for want of room that it had not foreseen (Users' guide, section 8).
bool wants_room(Mat factors, const char* what) {
  constexpr PetscInt status = 1, too_few_integers = -8, too_few_reals = -9;
  PetscInt found = 0;
  check(MatMumpsGetInfog(factors, status, &found), what);
  return found == too_few_integers || found == too_few_reals;
}

/// Throws the factors away, and the analysis with them.
void begin_anew(KSP solver, const char* what) {
  Mat matrix = nullptr;
  check(KSPGetOperators(solver, &matrix, nullptr), what);
  check(PetscObjectReference(reinterpret_cast<PetscObject>(matrix)), what);
  check(KSPReset(solver), what);
  check(KSPSetOperators(solver, matrix, matrix), what);
  check(MatDestroy(&matrix), what);
}

}  // namespace

void set_up_with_room(KSP solver, const char* what) {
  constexpr PetscInt more_room = 14, first_per_cent = 50, most_per_cent = 2000;
  Mat factors = factors_of(solver, what);
  check(KSPSetUp(solver), what);
  for (PetscInt per_cent = first_per_cent; factors != nullptr && per_cent <= most_per_cent; per_cent *= 2) {
    if (!wants_room(factors, what)) return;
    begin_anew(solver, what);
    factors = factors_of(solver, what);
    check(MatMumpsSetIcntl(factors, more_room, per_cent), what);
    check(KSPSetUp(solver), what);
  }
}

}  // namespace breccia::quasistatic
