#include "films/solver/minimal_residuals.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Jacobi>

namespace breccia::films {
namespace {

/// The matrix of the map in the basis of its Krylov space, made triangular by a rotation for each column.
class TriangularForm {
 public:
  explicit TriangularForm(double norm_of_right_side, int most) : right_side_(Eigen::VectorXd::Zero(most + 1)) {
    right_side_[0] = norm_of_right_side;
  }

  /// Adds a column, which has one row more than there will be columns.
  void add(Eigen::VectorXd column) {
    const auto number = static_cast<Eigen::Index>(columns_.size());
    for (Eigen::Index i = 0; i < number; ++i) {
      column.applyOnTheLeft(i, i + 1, rotations_[static_cast<std::size_t>(i)].adjoint());
    }
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(column[number], column[number + 1], &column[number]);
    column[number + 1] = 0.0;
    right_side_.applyOnTheLeft(number, number + 1, rotation.adjoint());
    rotations_.push_back(rotation);
    columns_.push_back(std::move(column));
  }

  /// Norm of the smallest residual in the space.
  [[nodiscard]] double residual() const { return std::abs(right_side_[static_cast<Eigen::Index>(columns_.size())]); }

  /// The coefficients of the vector with the smallest residual.
  [[nodiscard]] Eigen::VectorXd coefficients() const {
    const auto count = static_cast<Eigen::Index>(columns_.size());
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      triangle.col(k).head(k + 1) = columns_[static_cast<std::size_t>(k)].head(k + 1);
    }
    return triangle.triangularView<Eigen::Upper>().solve(right_side_.head(count));
  }

 private:
  Eigen::VectorXd right_side_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
  std::vector<Eigen::VectorXd> columns_;
};

/// The iterations from a zero start until a residual, relative to the right side, is reached or seems to be.
KrylovSolution one_cycle(const LinearMap& matrix, const LinearMap& preconditioner, const Eigen::VectorXd& right_side,
                         double tolerance) {
  constexpr int most_iterations = 50;
  const double norm = right_side.norm();
  std::vector<Eigen::VectorXd> basis = {right_side / norm}, preconditioned;
  TriangularForm form(norm, most_iterations);
  KrylovSolution found{.solution = Eigen::VectorXd::Zero(right_side.size()), .residual = 1.0};
  while (found.iterations < most_iterations && found.residual > tolerance) {
    Eigen::VectorXd next = matrix(preconditioned.emplace_back(preconditioner(basis.back())));
    Eigen::VectorXd column = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(basis.size()) + 1);
    // Twice, so that the basis stays orthogonal to rounding.
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t i = 0; i < basis.size(); ++i) {
        const double share = basis[i].dot(next);
        column[static_cast<Eigen::Index>(i)] += share;
        next -= share * basis[i];
      }
    }
    const double length = next.norm();
    column[column.size() - 1] = length;
    form.add(column);
    ++found.iterations;
    found.residual = form.residual() / norm;
    if (length == 0.0) break;
    basis.emplace_back(next / length);
  }
  const auto coefficients = form.coefficients();
  for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
    found.solution += coefficients[i] * preconditioned[static_cast<std::size_t>(i)];
  }
  return found;
}

}  // namespace

KrylovSolution minimal_residuals(const LinearMap& matrix, const LinearMap& preconditioner,
                                 const Eigen::VectorXd& right_side, double tolerance) {
  constexpr int most_iterations = 150;
  const double norm = right_side.norm();
  KrylovSolution found{.solution = Eigen::VectorXd::Zero(right_side.size())};
  if (norm == 0.0) return found;
  Eigen::VectorXd missing = right_side;
  found.residual = 1.0;
  while (found.iterations < most_iterations && found.residual > tolerance) {
    const auto cycle = one_cycle(matrix, preconditioner, missing, tolerance / found.residual);
    found.solution += cycle.solution;
    found.iterations += cycle.iterations;
    missing = right_side - matrix(found.solution);
    const double residual = missing.norm() / norm;
    const bool is_stuck = !(residual < found.residual);
    found.residual = residual;
    if (is_stuck) break;
  }
  return found;
}

}  // namespace breccia::films
