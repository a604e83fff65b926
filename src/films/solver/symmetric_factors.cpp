#include "solver/symmetric_factors.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/parallel/session.hpp"

namespace breccia::films {

using parallel::check;

SymmetricFactors::~SymmetricFactors() {
  MatDestroy(&factors_);
  MatDestroy(&view_);
}

void SymmetricFactors::factorise(Sparse lower_triangle) {
  constexpr const char* what = "factorising the matrix of the films";
  parallel::start();
  matrix_ = std::move(lower_triangle);
  matrix_.makeCompressed();
  const auto size = static_cast<PetscInt>(matrix_.rows());
  MatDestroy(&view_);
  check(MatCreateSeqSBAIJWithArrays(PETSC_COMM_SELF, 1, size, size, matrix_.outerIndexPtr(), matrix_.innerIndexPtr(),
                                    matrix_.valuePtr(), &view_),
        what);
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info), what);
  if (factors_ == nullptr) {
    check(MatGetFactor(view_, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, &factors_), what);
    constexpr PetscInt more_memory = 14, per_cent = 30;
    check(MatMumpsSetIcntl(factors_, more_memory, per_cent), what);
    check(MatCholeskyFactorSymbolic(factors_, view_, nullptr, &info), what);
  }
  check(MatCholeskyFactorNumeric(factors_, view_, &info), what);
  MatFactorError error = MAT_FACTOR_NOERROR;
  check(MatFactorGetError(factors_, &error), what);
  if (error != MAT_FACTOR_NOERROR) {
    throw NumericalError(
        "films: the matrix cannot be factorised: memory may have run out (fewer grains take less), or a modulus of the "
        "binder is not positive");
  }
}

Eigen::VectorXd SymmetricFactors::solve_once(const Eigen::VectorXd& right_side) const {
  constexpr const char* what = "solving for the displacements of the grains";
  Eigen::VectorXd solution(right_side.size());
  Vec b = nullptr, x = nullptr;
  const auto size = static_cast<PetscInt>(right_side.size());
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size, right_side.data(), &b), what);
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size, solution.data(), &x), what);
  check(MatSolve(factors_, b, x), what);
  VecDestroy(&b);
  VecDestroy(&x);
  return solution;
}

Eigen::VectorXd SymmetricFactors::solve(const Eigen::VectorXd& right_side) {
  constexpr double largest_residual = 1e-6;
  Eigen::VectorXd solution = solve_once(right_side);
  const auto missing = [&]() -> Eigen::VectorXd {
    return right_side - matrix_.selfadjointView<Eigen::Lower>() * solution;
  };
  solution += solve_once(missing());
  residual_ = missing().norm() / std::max(right_side.norm(), 1e-300);
  if (!(residual_ <= largest_residual)) {
    throw NumericalError(fmt::format("films: the residual of a solution is {:.1e} of the load", residual_));
  }
  return solution;
}

double SymmetricFactors::entries() const {
  constexpr PetscInt real_entries = 9;  // in millions, if negative
  PetscInt count = 0;
  check(MatMumpsGetInfog(factors_, real_entries, &count), "reading the size of the factors");
  return count < 0 ? -1e6 * count : count;
}

}  // namespace breccia::films
