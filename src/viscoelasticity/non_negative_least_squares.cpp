#include "viscoelasticity/non_negative_least_squares.hpp"

#include <algorithm>
#include <vector>

#include "breccia/error.hpp"

#include "viscoelasticity/least_squares.hpp"

namespace breccia {
namespace {

using Indices = std::vector<Eigen::Index>;

/// The unconstrained least-squares solution in a subset of the variables.
Eigen::VectorXd solve_for(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, const Indices& variables) {
  return least_squares(matrix(Eigen::all, variables), right);
}

/// Moves x towards the solution in the free variables until the first of them becomes zero, fixes that variable at
/// zero, and repeats this until the solution is positive.
void descend(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, Indices& free, Eigen::VectorXd& x) {
  while (!free.empty()) {
    const Eigen::VectorXd target = solve_for(matrix, right, free);
    double share = 1.0;
    for (std::size_t i = 0; i < free.size(); ++i) {
      const double to = target[static_cast<Eigen::Index>(i)], from = x[free[i]];
      if (to <= 0.0) share = std::min(share, from / (from - to));
    }
    for (std::size_t i = 0; i < free.size(); ++i) {
      double& value = x[free[i]];
      const double to = target[static_cast<Eigen::Index>(i)];
      value += share * (to - value);
      if (to <= 0.0 && value <= 1e-14 * x.maxCoeff()) value = 0.0;
    }
    if (share == 1.0) return;
    std::erase_if(free, [&](Eigen::Index j) { return x[j] == 0.0; });
  }
}

}  // namespace

Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  const Eigen::VectorXd scale = matrix.colwise().norm().cwiseMax(1e-300);
  const Eigen::MatrixXd scaled = matrix * scale.cwiseInverse().asDiagonal();
  const double rounding = 1e-14 * right.norm();
  const auto count = matrix.cols();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(count);
  Indices free;
  for (Eigen::Index step = 0; step < 20 * count; ++step) {
    Eigen::VectorXd gain = scaled.transpose() * (right - scaled * x);
    for (const auto j : free) gain[j] = 0.0;
    // If the gradient of a variable is positive only by rounding, its solution is negative, and the next one is tried.
    Eigen::Index best = 0;
    while (gain.maxCoeff(&best) > rounding) {
      auto candidates = free;
      candidates.push_back(best);
      if (solve_for(scaled, right, candidates).tail(1)[0] > 0.0) break;
      gain[best] = 0.0;
    }
    if (!(gain[best] > rounding)) return x.cwiseQuotient(scale);
    free.push_back(best);
    descend(scaled, right, free, x);
  }
  throw NumericalError("non-negative least squares: no convergence; are all data finite?");
}

}  // namespace breccia
