#include "films/solver/symmetric_factors.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "parallel/common_failure.hpp"
#include "parallel/communicator.hpp"
#include "parallel/reduction.hpp"
#include "parallel/session.hpp"

namespace breccia::films {

void SymmetricFactors::factorise(std::function<Sparse()> lower_triangle) {
  parallel::start();
  parallel::done_by_first([&] {
    matrix_ = lower_triangle();
    matrix_.makeCompressed();
  });
  if (!mumps_) {
    mumps_.emplace(matrix_, FactorBlocks::full);
    if (mumps_->memory() > memory_) mumps_->keep_in_files(directory_.emplace().path());
  }
  mumps_->factorise(matrix_.valuePtr());
}

/// Solves by the factors without refinement, with the right side and the solution on the process that has the matrix.
Eigen::VectorXd SymmetricFactors::solve_once(const Eigen::VectorXd& right_side) const {
  Eigen::VectorXd solution = right_side;
  mumps_->solve(solution.data());
  return solution;
}

Eigen::VectorXd SymmetricFactors::solve(const Eigen::VectorXd& right_side) {
  constexpr double largest_residual = 1e-6;
  Eigen::VectorXd solution = solve_once(right_side);
  const auto missing = [&]() -> Eigen::VectorXd {
    if (parallel::rank() != 0) return right_side;
    return right_side - matrix_.selfadjointView<Eigen::Lower>() * solution;
  };
  solution += solve_once(missing());
  effort_.residual = missing().norm() / std::max(right_side.norm(), 1e-300);
  parallel::copy_from_first(std::span(solution.data(), static_cast<std::size_t>(solution.size())));
  parallel::copy_from_first(std::span(&effort_.residual, 1));
  if (!(effort_.residual <= largest_residual)) {
    throw NumericalError(fmt::format("films: the residual of a solution is {:.1e} of the load", effort_.residual));
  }
  return solution;
}

}  // namespace breccia::films
