#include "solvers/coarse_solver.hpp"

#include "solvers/breakdown.hpp"

namespace breccia::quasistatic {
namespace {

constexpr const char* cannot_be_factorised =
    "quasi-static solver: the stiffness matrix of the coarse problem cannot be factorised: memory may have run out "
    "(fewer cells take less), or a modulus is zero";

}  // namespace

CoarseSolver::CoarseSolver(int unknowns, const std::vector<Part>& parts, double stiffness_of_held) {
  constexpr const char* what = "factorising the coarse stiffness matrix";
  std::vector<int> rows, columns;
  std::vector<double> values;
  std::vector<bool> is_stiff(static_cast<std::size_t>(unknowns), false);
  const auto add = [&](int row, int column, double value) {
    rows.push_back(row);
    columns.push_back(column);
    values.push_back(value);
  };
  for (const auto& [indices, matrix] : parts) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] < 0) continue;
      is_stiff[static_cast<std::size_t>(indices[i])] = true;
      for (std::size_t j = 0; j < indices.size(); ++j) {
        // One triangle is enough for Cholesky.
        if (indices[j] < indices[i]) continue;
        add(indices[i], indices[j], (*matrix)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      }
    }
  }
  for (int u = 0; u < unknowns; ++u) {
    if (!is_stiff[static_cast<std::size_t>(u)]) add(u, u, stiffness_of_held);
  }
  check(MatCreate(PETSC_COMM_SELF, matrix_.put()), what);
  check(MatSetSizes(matrix_.get(), unknowns, unknowns, unknowns, unknowns), what);
  check(MatSetType(matrix_.get(), MATSEQAIJ), what);
  check(MatSetPreallocationCOO(matrix_.get(), static_cast<PetscCount>(values.size()), rows.data(), columns.data()),
        what);
  check(MatSetValuesCOO(matrix_.get(), values.data(), INSERT_VALUES), what);
  check(MatSetOption(matrix_.get(), MAT_SPD, PETSC_TRUE), what);

  check(KSPCreate(PETSC_COMM_SELF, solver_.put()), what);
  check(KSPSetType(solver_.get(), KSPPREONLY), what);
  check(KSPSetOperators(solver_.get(), matrix_.get(), matrix_.get()), what);
  PC factors = nullptr;
  check(KSPGetPC(solver_.get(), &factors), what);
  check(PCSetType(factors, PCCHOLESKY), what);
  check(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS), what);
  check(KSPSetUp(solver_.get()), what);
  require_no_breakdown(solver_.get(), cannot_be_factorised);
}

void CoarseSolver::solve(const std::vector<double>& right, std::vector<double>& solution) const {
  constexpr const char* what = "solving with the coarse stiffness matrix";
  const auto size = static_cast<PetscInt>(right.size());
  NodalVector from, to;
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size, right.data(), from.put()), what);
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size, solution.data(), to.put()), what);
  check(KSPSolve(solver_.get(), from.get(), to.get()), what);
  require_no_breakdown(solver_.get(), cannot_be_factorised);
}

}  // namespace breccia::quasistatic
