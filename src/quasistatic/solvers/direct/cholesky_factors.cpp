#include "quasistatic/solvers/direct/cholesky_factors.hpp"

#include <fmt/format.h>

#include "quasistatic/solvers/direct/breakdown.hpp"
#include "quasistatic/solvers/direct/sparse_factors.hpp"

namespace breccia::quasistatic {

int CholeskyFactors::first_of_process(int owned) {
  int before = 0;
  MPI_Exscan(&owned, &before, 1, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
  return parallel::rank() == 0 ? 0 : before;  // MPI leaves the value undefined on the first process
}

CholeskyFactors::CholeskyFactors(int owned, MatrixEntries entries, const char* what) : owned_(owned), what_(what) {
  constexpr const char* doing = "factorising a sparse matrix";
  check(MatCreate(PETSC_COMM_WORLD, matrix_.put()), doing);
  check(MatSetSizes(matrix_.get(), owned, owned, PETSC_DETERMINE, PETSC_DETERMINE), doing);
  check(MatSetType(matrix_.get(), MATAIJ), doing);
  // PETSc sorts the places in place.
  check(MatSetPreallocationCOO(matrix_.get(), static_cast<PetscCount>(entries.values.size()), entries.rows.data(),
                               entries.columns.data()),
        doing);
  check(MatSetValuesCOO(matrix_.get(), entries.values.data(), INSERT_VALUES), doing);
  check(MatSetOption(matrix_.get(), MAT_SPD, PETSC_TRUE), doing);

  check(KSPCreate(PETSC_COMM_WORLD, solver_.put()), doing);
  check(KSPSetType(solver_.get(), KSPPREONLY), doing);
  check(KSPSetOperators(solver_.get(), matrix_.get(), matrix_.get()), doing);
  PC factors = nullptr;
  check(KSPGetPC(solver_.get(), &factors), doing);
  check(PCSetType(factors, PCCHOLESKY), doing);
  check(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS), doing);
  set_up_with_room(solver_.get(), doing);
  require_no_breakdown();
}

void CholeskyFactors::require_no_breakdown() const {
  quasistatic::require_no_breakdown(
      solver_.get(), fmt::format("quasi-static solver: {} cannot be factorised: memory may have run out (fewer cells "
                                 "take less), or a modulus is zero",
                                 what_)
                         .c_str());
}

void CholeskyFactors::solve(const double* right, double* solution) const {
  constexpr const char* doing = "solving with a sparse matrix";
  NodalVector from, to;
  check(VecCreateMPIWithArray(PETSC_COMM_WORLD, 1, owned_, PETSC_DETERMINE, right, from.put()), doing);
  check(VecCreateMPIWithArray(PETSC_COMM_WORLD, 1, owned_, PETSC_DETERMINE, solution, to.put()), doing);
  check(KSPSolve(solver_.get(), from.get(), to.get()), doing);
  require_no_breakdown();
}

std::int64_t CholeskyFactors::unknowns() const {
  PetscInt unknowns = 0;
  check(MatGetSize(matrix_.get(), &unknowns, nullptr), "counting the unknowns of a sparse matrix");
  return unknowns;
}

}  // namespace breccia::quasistatic
