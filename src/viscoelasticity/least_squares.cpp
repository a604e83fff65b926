#include "viscoelasticity/least_squares.hpp"

#include <Eigen/Dense>
#include <unsupported/Eigen/NonLinearOptimization>

namespace breccia {
namespace {

/// A problem in the form that Eigen's search needs.
class Functor {
 public:
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  explicit Functor(const NonlinearLeastSquares& problem) : problem_(&problem) {}

  [[nodiscard]] int values() const { return static_cast<int>(problem_->values); }

  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& deviations) const {
    problem_->deviations(x, deviations);
    return 0;
  }

  int df(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian) const {
    problem_->jacobian(x, jacobian);
    return 0;
  }

 private:
  const NonlinearLeastSquares* problem_;
};

}  // namespace

Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.colPivHouseholderQr().solve(b);
}

Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(columns);
  return factors.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), factors.rank());
}

std::optional<Eigen::VectorXd> variances(const Eigen::MatrixXd& jacobian) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> normal(jacobian.transpose() * jacobian);
  if (!normal.isInvertible()) return std::nullopt;
  return normal.inverse().diagonal();
}

bool search_least_squares(const NonlinearLeastSquares& problem, const SearchLimits& limits, Eigen::VectorXd& x) {
  Functor functor(problem);
  Eigen::LevenbergMarquardt<Functor> search(functor);
  search.parameters.xtol = limits.relative_step;
  search.parameters.ftol = limits.relative_decrease;
  search.parameters.maxfev = limits.most_evaluations;
  return search.minimize(x) != Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation;
}

}  // namespace breccia
