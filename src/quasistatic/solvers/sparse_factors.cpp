#include "solvers/sparse_factors.hpp"

#include <array>
#include <string>
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
  constexpr PetscInt status = 1, too_few_integers = -8, too_few_reals = -9, too_small_to_send = -17,
                     too_small_to_receive = -20;
  PetscInt found = 0;
  check(MatMumpsGetInfog(factors, status, &found), what);
  return found == too_few_integers || found == too_few_reals || found == too_small_to_send ||
         found == too_small_to_receive;
}

/// Gives MUMPS more room than its analysis foresees, as long as this lives. It is an option of PETSc, since one that
/// the user has set would replace what MatMumpsSetIcntl() says.
class MoreRoom {
 public:
  MoreRoom(PetscInt per_cent, const char* what) {
    std::array<char, 64> set{};
    check(PetscOptionsGetString(nullptr, nullptr, name, set.data(), set.size(), &was_set_), what);
    before_ = set.data();
    check(PetscOptionsSetValue(nullptr, name, std::to_string(per_cent).c_str()), what);
  }
  ~MoreRoom() {
    if (was_set_ == PETSC_TRUE) {
      PetscOptionsSetValue(nullptr, name, before_.c_str());
    } else {
      PetscOptionsClearValue(nullptr, name);
    }
  }
  MoreRoom(const MoreRoom&) = delete;
  MoreRoom& operator=(const MoreRoom&) = delete;

 private:
  static constexpr const char* name = "-mat_mumps_icntl_14";  // in per cent
  PetscBool was_set_ = PETSC_FALSE;
  std::string before_;
};

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
  constexpr PetscInt first_per_cent = 50, most_per_cent = 2000;
  Mat factors = factors_of(solver, what);
  check(KSPSetUp(solver), what);
  for (PetscInt per_cent = first_per_cent; factors != nullptr && per_cent <= most_per_cent; per_cent *= 2) {
    if (!wants_room(factors, what)) return;
    begin_anew(solver, what);
    const MoreRoom room(per_cent, what);
    factors = factors_of(solver, what);
    check(KSPSetUp(solver), what);
  }
}

}  // namespace breccia::quasistatic
