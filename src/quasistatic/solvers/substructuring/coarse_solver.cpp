#include "quasistatic/solvers/substructuring/coarse_solver.hpp"

#include <numeric>
#include <span>

#include "quasistatic/solvers/direct/breakdown.hpp"
#include "quasistatic/solvers/direct/sparse_factors.hpp"

namespace breccia::quasistatic {
namespace {

constexpr const char* cannot_be_factorised =
    "quasi-static solver: the stiffness matrix of the coarse problem cannot be factorised: memory may have run out "
    "(fewer cells take less), or a modulus is zero";

/// The numbers of the unknowns of this process among those of all processes.
std::vector<int> numbers_in_all(int owned, int unknowns, const SharedValues& shared) {
  int before = 0;
  MPI_Exscan(&owned, &before, 1, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
  if (parallel::rank() == 0) before = 0;  // MPI leaves the value undefined on the first process
  std::vector<int> numbers(static_cast<std::size_t>(unknowns));
  std::iota(numbers.begin(), numbers.begin() + owned, before);
  shared.copy_from_owners(std::span(numbers));
  return numbers;
}

}  // namespace

CoarseSolver::CoarseSolver(int owned, int unknowns, const SharedValues& shared, const std::vector<Part>& parts,
                           double stiffness_of_held)
    : owned_(owned) {
  constexpr const char* what = "factorising the coarse stiffness matrix";
  check(MatCreate(PETSC_COMM_WORLD, matrix_.put()), what);
  check(MatSetSizes(matrix_.get(), owned, owned, PETSC_DETERMINE, PETSC_DETERMINE), what);
  check(MatSetType(matrix_.get(), MATAIJ), what);
  const auto numbers = numbers_in_all(owned, unknowns, shared);
  std::vector<int> rows, columns;
  std::vector<double> values;
  const auto add = [&](int row, int column, double value) {
    rows.push_back(row);
    columns.push_back(column);
    values.push_back(value);
  };
  std::vector<double> is_stiff(static_cast<std::size_t>(unknowns), 0.0);
  for (const auto& [indices, matrix] : parts) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] < 0) continue;
      const auto row = static_cast<std::size_t>(indices[i]);
      is_stiff[row] = 1.0;
      for (std::size_t j = 0; j < indices.size(); ++j) {
        if (indices[j] < 0) continue;
        const int column = numbers[static_cast<std::size_t>(indices[j])];
        // One triangle is enough for Cholesky.
        if (column < numbers[row]) continue;
        add(numbers[row], column, (*matrix)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      }
    }
  }
  shared.add_to_owners(is_stiff);
  for (std::size_t u = 0; u < static_cast<std::size_t>(owned); ++u) {
    if (is_stiff[u] == 0.0) add(numbers[u], numbers[u], stiffness_of_held);
  }
  check(MatSetPreallocationCOO(matrix_.get(), static_cast<PetscCount>(values.size()), rows.data(), columns.data()),
        what);
  check(MatSetValuesCOO(matrix_.get(), values.data(), INSERT_VALUES), what);
  check(MatSetOption(matrix_.get(), MAT_SPD, PETSC_TRUE), what);

  check(KSPCreate(PETSC_COMM_WORLD, solver_.put()), what);
  check(KSPSetType(solver_.get(), KSPPREONLY), what);
  check(KSPSetOperators(solver_.get(), matrix_.get(), matrix_.get()), what);
  PC factors = nullptr;
  check(KSPGetPC(solver_.get(), &factors), what);
  check(PCSetType(factors, PCCHOLESKY), what);
  check(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS), what);
  set_up_with_room(solver_.get(), what);
  require_no_breakdown(solver_.get(), cannot_be_factorised);
}

void CoarseSolver::solve(const std::vector<double>& right, std::vector<double>& solution) const {
  constexpr const char* what = "solving with the coarse stiffness matrix";
  NodalVector from, to;
  check(VecCreateMPIWithArray(PETSC_COMM_WORLD, 1, owned_, PETSC_DETERMINE, right.data(), from.put()), what);
  check(VecCreateMPIWithArray(PETSC_COMM_WORLD, 1, owned_, PETSC_DETERMINE, solution.data(), to.put()), what);
  check(KSPSolve(solver_.get(), from.get(), to.get()), what);
  require_no_breakdown(solver_.get(), cannot_be_factorised);
}

std::int64_t CoarseSolver::unknowns() const {
  PetscInt unknowns = 0;
  check(MatGetSize(matrix_.get(), &unknowns, nullptr), "counting the unknowns of the coarse problem");
  return unknowns;
}

}  // namespace breccia::quasistatic
