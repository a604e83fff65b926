#include "films/solver/compressed_factors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <span>
#include <utility>
#include <vector>

#include "breccia/error.hpp"

#include "parallel/common_failure.hpp"
#include "parallel/communicator.hpp"
#include "parallel/reduction.hpp"
#include "parallel/session.hpp"

namespace breccia::films {
namespace {

constexpr double largest_residual = 1e-10;  // of the scaled system over its right side

/// Copies a number or a vector of the first process to all.
void copy_from_first(double& number) {
  parallel::copy_from_first(std::span(&number, 1));
}
void copy_from_first(Eigen::VectorXd& vector) {
  parallel::copy_from_first(std::span(vector.data(), static_cast<std::size_t>(vector.size())));
}

}  // namespace

void CompressedFactors::factorise(std::function<Sparse()> lower_triangle) {
  parallel::start();
  lower_triangle_ = std::move(lower_triangle);
  parallel::done_by_first([&] {
    matrix_ = lower_triangle_();
    matrix_.makeCompressed();
    const auto factor = [](double entry) { return entry == 0.0 ? 1.0 : 1.0 / std::sqrt(std::abs(entry)); };
    scale_ = matrix_.diagonal().unaryExpr(factor);
    matrix_ = scale_.asDiagonal() * matrix_ * scale_.asDiagonal();
  });
  if (!mumps_) mumps_.emplace(matrix_, FactorBlocks::low_rank);
  made_.reset();
  make_factors(Accuracy::usual);
}

/// Makes factors unless the present ones have this accuracy. Factors of low rank that cannot be made are left out.
void CompressedFactors::make_factors(Accuracy accuracy) {
  if (made_ == accuracy) return;
  made_.reset();
  if (accuracy == Accuracy::full) {
    full_.factorise(lower_triangle_);
    made_ = accuracy;
    return;
  }
  mumps_->set_error(accuracy == Accuracy::usual ? 1e-3 : 1e-5);
  std::vector<float> entries;
  parallel::done_by_first([&] { entries.assign(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros()); });
  try {
    mumps_->factorise(entries.data());
    made_ = accuracy;
  } catch (const NumericalError&) {
    // MUMPS fails on all processes at once; the next accuracy is tried.
  }
}

/// Solves by the factors on all processes, with the right side and the solution on the first one.
Eigen::VectorXd CompressedFactors::solve_once(const Eigen::VectorXd& right_side) const {
  Eigen::VectorXf single = right_side.cast<float>();
  mumps_->solve(single.data());
  return single.cast<double>();
}

/// Iterates on the first process, for which the others solve by the factors as often as it asks.
KrylovSolution CompressedFactors::iterate(const Eigen::VectorXd& right_side) {
  constexpr double goes_on = 1.0, is_done = 0.0;
  KrylovSolution found;
  double state = goes_on;
  std::exception_ptr failure;
  if (parallel::rank() != 0) {
    for (copy_from_first(state); state == goes_on; copy_from_first(state)) {
      try {
        in_iteration_();
        static_cast<void>(solve_once(right_side));
      } catch (...) {
        // The same fails on the first process, which then ends the iteration.
        failure = std::current_exception();
      }
    }
    parallel::throw_together(failure);
    return found;
  }
  const auto multiply = [&](const Eigen::VectorXd& vector) -> Eigen::VectorXd {
    return matrix_.selfadjointView<Eigen::Lower>() * vector;
  };
  const auto precondition = [&](const Eigen::VectorXd& vector) {
    copy_from_first(state);
    in_iteration_();
    return solve_once(vector);
  };
  try {
    found = minimal_residuals(multiply, precondition, right_side, largest_residual);
  } catch (...) {
    failure = std::current_exception();
  }
  state = is_done;
  copy_from_first(state);
  parallel::throw_together(failure);
  return found;
}

Eigen::VectorXd CompressedFactors::solve(const Eigen::VectorXd& right_side) {
  effort_ = {};
  const bool has_matrix = parallel::rank() == 0;
  Eigen::VectorXd scaled = right_side;
  if (has_matrix) scaled.array() *= scale_.array();
  for (const auto accuracy : {Accuracy::usual, Accuracy::fine}) {
    if (made_ != accuracy) ++effort_.factorisations;
    make_factors(accuracy);
    if (!made_) continue;
    auto found = iterate(scaled);
    std::array numbers = {found.residual, static_cast<double>(found.iterations)};
    parallel::copy_from_first(std::span(numbers));
    effort_.iterations += static_cast<int>(numbers[1]);
    if (!(numbers[0] <= largest_residual)) continue;
    Eigen::VectorXd solution = right_side;
    if (has_matrix) {
      const Eigen::VectorXd missing = scaled - matrix_.selfadjointView<Eigen::Lower>() * found.solution;
      effort_.residual = missing.cwiseQuotient(scale_).norm() / std::max(right_side.norm(), 1e-300);
      solution = scale_.cwiseProduct(found.solution);
    }
    copy_from_first(effort_.residual);
    copy_from_first(solution);
    return solution;
  }
  if (made_ != Accuracy::full) ++effort_.factorisations;
  make_factors(Accuracy::full);
  auto solution = full_.solve(right_side);
  effort_.residual = full_.effort().residual;
  return solution;
}

}  // namespace breccia::films
