#include "quasistatic/solvers/direct/sparse_factors.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "parallel/session.hpp"

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

/// Whether MUMPS has stopped because it needs more memory than its analysis has estimated (Users' guide, section 8).
bool wants_room(Mat factors, const char* what) {
  constexpr PetscInt status = 1, too_few_integers = -8, too_few_reals = -9, too_small_to_send = -17,
                     too_small_to_receive = -20;
  PetscInt found = 0;
  check(MatMumpsGetInfog(factors, status, &found), what);
  return found == too_few_integers || found == too_few_reals || found == too_small_to_send ||
         found == too_small_to_receive;
}

/// Number of the parameter of MUMPS, which is in per cent of the memory that the analysis estimates.
constexpr PetscInt more_room = 14;

/// The name of the option of PETSc for the additional memory of some factors.
std::string option_of_room(Mat factors, const char* what) {
  const char* before_name = nullptr;
  check(PetscObjectGetOptionsPrefix(reinterpret_cast<PetscObject>(factors), &before_name), what);
  return fmt::format("-{}mat_mumps_icntl_{}", before_name == nullptr ? "" : before_name, more_room);
}

/// Sets the memory that MUMPS has in addition to the estimate of its analysis, during the lifetime of this object. It
/// is set as an option of PETSc, since an option of the user would override MatMumpsSetIcntl().
class MoreRoom {
 public:
  MoreRoom(std::string option, PetscInt per_cent, const char* what) : option_(std::move(option)) {
    std::array<char, 64> set{};
    check(PetscOptionsGetString(nullptr, nullptr, option_.c_str(), set.data(), set.size(), &was_set_), what);
    before_ = set.data();
    check(PetscOptionsSetValue(nullptr, option_.c_str(), std::to_string(per_cent).c_str()), what);
  }
  ~MoreRoom() {
    if (was_set_ == PETSC_TRUE) {
      PetscOptionsSetValue(nullptr, option_.c_str(), before_.c_str());
    } else {
      PetscOptionsClearValue(nullptr, option_.c_str());
    }
  }
  MoreRoom(const MoreRoom&) = delete;
  MoreRoom& operator=(const MoreRoom&) = delete;
  MoreRoom(MoreRoom&&) = delete;
  MoreRoom& operator=(MoreRoom&&) = delete;

 private:
  std::string option_;
  PetscBool was_set_ = PETSC_FALSE;
  std::string before_;
};

/// Discards the factors together with the analysis.
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
  if (factors == nullptr) return;
  PetscInt per_cent = 0;
  check(MatMumpsGetIcntl(factors, more_room, &per_cent), what);
  const auto option = option_of_room(factors, what);
  while (per_cent < most_per_cent && wants_room(factors, what)) {
    per_cent = std::max(first_per_cent, 2 * per_cent);
    begin_anew(solver, what);
    const MoreRoom room(option, per_cent, what);
    factors = factors_of(solver, what);
    check(KSPSetUp(solver), what);
  }
}

}  // namespace breccia::quasistatic
