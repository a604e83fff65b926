#include "films/solver/compressed_factors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "films/solver/minimal_residuals.hpp"
#include "parallel/communicator.hpp"
#include "parallel/reduction.hpp"
#include "parallel/session.hpp"

namespace breccia::films {
namespace {

/// Copies a vector of the first process to all.
void copy_from_first(Eigen::VectorXd& vector) {
  parallel::copy_from_first(std::span(vector.data(), static_cast<std::size_t>(vector.size())));
}

}  // namespace

void CompressedFactors::factorise(const std::function<Sparse()>& lower_triangle) {
  parallel::start();
  if (parallel::rank() == 0) {
    matrix_ = lower_triangle();
    matrix_.makeCompressed();
    scale_ = matrix_.diagonal().unaryExpr(
        [](double entry) { return entry == 0.0 ? 1.0 : 1.0 / std::sqrt(std::abs(entry)); });
    matrix_ = scale_.asDiagonal() * matrix_ * scale_.asDiagonal();
  }
  if (!mumps_) mumps_.emplace(matrix_, FactorBlocks::low_rank);
  make_factors();
}

void CompressedFactors::make_factors() {
  mumps_->set_error(error_);
  std::vector<float> entries(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros());
  mumps_->factorise(entries.data());
}

Eigen::VectorXd CompressedFactors::solve(const Eigen::VectorXd& right_side) {
  constexpr double tolerance = 1e-10, smallest_error = 1e-6, factor = 0.1;
  constexpr int most_iterations = 100;
  const bool has_matrix = parallel::rank() == 0;
  // All processes have all vectors, and the first one the matrix.
  const auto multiplied = [&](const Eigen::VectorXd& vector) {
    Eigen::VectorXd product = vector;
    if (has_matrix) product = matrix_.selfadjointView<Eigen::Lower>() * vector;
    copy_from_first(product);
    return product;
  };
  const auto solved = [&](const Eigen::VectorXd& vector) {
    Eigen::VectorXf single = vector.cast<float>();
    mumps_->solve(single.data());
    Eigen::VectorXd solution = single.cast<double>();
    copy_from_first(solution);
    return solution;
  };
  Eigen::VectorXd scaled = right_side;
  if (has_matrix) scaled.array() *= scale_.array();
  copy_from_first(scaled);
  for (;;) {
    auto found = minimal_residuals(multiplied, solved, scaled, tolerance, most_iterations);
    iterations_ = found.iterations;
    residual_ = (scaled - multiplied(found.solution)).norm() / std::max(scaled.norm(), 1e-300);
    if (residual_ <= 10.0 * tolerance) {
      if (has_matrix) found.solution.array() *= scale_.array();
      copy_from_first(found.solution);
      return std::move(found.solution);
    }
    if (error_ <= smallest_error) {
      throw NumericalError(fmt::format("films: the residual of a solution is {:.1e} of the load after {} iterations",
                                       residual_, iterations_));
    }
    error_ *= factor;
    make_factors();
  }
}

}  // namespace breccia::films
