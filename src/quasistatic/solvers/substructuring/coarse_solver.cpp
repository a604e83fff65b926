#include "quasistatic/solvers/substructuring/coarse_solver.hpp"

#include <numeric>
#include <span>

namespace breccia::quasistatic {
namespace {

/// The numbers of the unknowns of this process among those of all processes.
std::vector<int> numbers_in_all(int owned, int unknowns, const SharedValues& shared) {
  std::vector<int> numbers(static_cast<std::size_t>(unknowns));
  std::iota(numbers.begin(), numbers.begin() + owned, CholeskyFactors::first_of_process(owned));
  shared.copy_from_owners(std::span(numbers));
  return numbers;
}

/// The entries of the sum of the small matrices of this process.
MatrixEntries add_up(int owned, int unknowns, const SharedValues& shared, const std::vector<CoarseSolver::Part>& parts,
                     double stiffness_of_held) {
  const auto numbers = numbers_in_all(owned, unknowns, shared);
  MatrixEntries entries;
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
        entries.add(numbers[row], column, (*matrix)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      }
    }
  }
  shared.add_to_owners(is_stiff);
  for (std::size_t u = 0; u < static_cast<std::size_t>(owned); ++u) {
    if (is_stiff[u] == 0.0) entries.add(numbers[u], numbers[u], stiffness_of_held);
  }
  return entries;
}

}  // namespace

CoarseSolver::CoarseSolver(int owned, int unknowns, const SharedValues& shared, const std::vector<Part>& parts,
                           double stiffness_of_held)
    : factors_(owned, add_up(owned, unknowns, shared, parts, stiffness_of_held),
               "the stiffness matrix of the coarse problem") {}

void CoarseSolver::solve(const std::vector<double>& right, std::vector<double>& solution) const {
  factors_.solve(right.data(), solution.data());
}

}  // namespace breccia::quasistatic
