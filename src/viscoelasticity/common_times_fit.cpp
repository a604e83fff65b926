#include "viscoelasticity/common_times_fit.hpp"

#include <numeric>
#include <utility>

#include "viscoelasticity/least_squares.hpp"
#include "viscoelasticity/non_negative_least_squares.hpp"

namespace breccia {
namespace {

/// Non-negative least squares. First components are left out as long as some are negative; this takes a few solutions,
/// whereas the active-set method takes one for each component. The result is the minimum if no component that is left
/// out would decrease the sum of squares by being positive; otherwise the active-set method is used.
Eigen::VectorXd non_negative_solution(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right) {
  const Eigen::VectorXd scale = columns.colwise().norm().cwiseMax(1e-300);
  const Eigen::MatrixXd scaled = columns * scale.cwiseInverse().asDiagonal();
  std::vector<Eigen::Index> used(static_cast<std::size_t>(columns.cols()));
  std::iota(used.begin(), used.end(), Eigen::Index{0});
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(columns.cols());
  while (!used.empty()) {
    const Eigen::VectorXd some = least_squares(scaled(Eigen::all, used), right);
    solution.setZero();
    solution(used) = some;
    if (some.allFinite() && some.minCoeff() >= 0.0) break;
    std::erase_if(used, [&](Eigen::Index k) { return !(solution[k] >= 0.0); });
  }
  constexpr double rounding = 1e-12;
  const Eigen::VectorXd gain = scaled.transpose() * (right - scaled * solution);
  const bool is_least = used.size() == static_cast<std::size_t>(columns.cols()) ||
                        (!used.empty() && gain.maxCoeff() <= rounding * right.norm());
  return is_least ? solution.cwiseQuotient(scale) : non_negative_least_squares(columns, right);
}

std::vector<Eigen::Index> positive_components(const Eigen::VectorXd& strengths) {
  std::vector<Eigen::Index> positive;
  for (Eigen::Index k = 0; k < strengths.size(); ++k) {
    if (strengths[k] > 0.0) positive.push_back(k);
  }
  return positive;
}

}  // namespace

CommonTimesFit::CommonTimesFit(SampledModuli samples)
    : samples_(std::move(samples)), roots_of_weights_(Eigen::VectorXd::Ones(deviations_count())) {}

Eigen::Index CommonTimesFit::deviations_count() const {
  return samples_.times.size() * static_cast<Eigen::Index>(samples_.moduli.size());
}

/// The matrix of exp(-t_i / tau_k), with a last column of 1.
Eigen::MatrixXd CommonTimesFit::decays(const Eigen::VectorXd& relaxation_times) const {
  Eigen::MatrixXd columns(samples_.times.size(), relaxation_times.size() + 1);
  columns.leftCols(relaxation_times.size()) =
      (-samples_.times * relaxation_times.cwiseInverse().transpose()).array().exp();
  columns.rightCols(1).setOnes();
  return columns;
}

/// The square roots of the weights of one modulus.
Eigen::VectorXd CommonTimesFit::weights_of(std::size_t modulus) const {
  const auto rows = samples_.times.size();
  return roots_of_weights_.segment(static_cast<Eigen::Index>(modulus) * rows, rows);
}

Eigen::MatrixXd CommonTimesFit::weighted_columns(const Eigen::MatrixXd& decays, std::size_t modulus) const {
  return weights_of(modulus).cwiseQuotient(samples_.moduli[modulus]).asDiagonal() * decays;
}

Eigen::MatrixXd CommonTimesFit::strengths(const Eigen::VectorXd& relaxation_times) const {
  const auto columns = decays(relaxation_times);
  Eigen::MatrixXd all(columns.cols(), static_cast<Eigen::Index>(samples_.moduli.size()));
  for (std::size_t i = 0; i < samples_.moduli.size(); ++i) {
    all.col(static_cast<Eigen::Index>(i)) = non_negative_solution(weighted_columns(columns, i), weights_of(i));
  }
  return all;
}

Eigen::VectorXd CommonTimesFit::deviations(const Eigen::VectorXd& relaxation_times,
                                           const Eigen::MatrixXd& strengths) const {
  const auto rows = samples_.times.size();
  const Eigen::MatrixXd fitted = decays(relaxation_times) * strengths;
  Eigen::VectorXd all(deviations_count());
  for (std::size_t i = 0; i < samples_.moduli.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    all.segment(at * rows, rows) = fitted.col(at).cwiseQuotient(samples_.moduli[i]).array() - 1.0;
  }
  return all;
}

/// The derivatives of the weighted deviations with respect to the logarithms of the relaxation times, where the
/// strengths are optimal for each of them: the derivatives at constant strengths minus their projection onto the
/// columns of the terms in use (Kaufman's variant).
Eigen::MatrixXd CommonTimesFit::projected_derivatives(const Eigen::VectorXd& relaxation_times) const {
  const auto rows = samples_.times.size();
  const auto terms = relaxation_times.size();
  const auto columns = decays(relaxation_times);
  const auto of_terms = strengths(relaxation_times);
  const Eigen::MatrixXd by_logarithm =
      columns.leftCols(terms).cwiseProduct(samples_.times * relaxation_times.cwiseInverse().transpose());
  Eigen::MatrixXd jacobian(deviations_count(), terms);
  for (std::size_t i = 0; i < samples_.moduli.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const Eigen::VectorXd strength = of_terms.col(at);
    const Eigen::MatrixXd derivatives = weighted_columns(by_logarithm, i) * strength.head(terms).asDiagonal();
    const Eigen::MatrixXd basis =
        orthonormal_basis(weighted_columns(columns, i)(Eigen::all, positive_components(strength)));
    jacobian.middleRows(at * rows, rows) = derivatives - basis * (basis.transpose() * derivatives);
  }
  return jacobian;
}

void CommonTimesFit::move(Eigen::VectorXd& logarithms, double least, double most, int most_evaluations) const {
  const auto times_of = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return x.cwiseMax(least).cwiseMin(most).array().exp();
  };
  const NonlinearLeastSquares problem = {
      deviations_count(),
      [&](const Eigen::VectorXd& x, Eigen::VectorXd& f) {
        const auto times = times_of(x);
        f = deviations(times, strengths(times)).cwiseProduct(roots_of_weights_);
      },
      [&](const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian) { jacobian = projected_derivatives(times_of(x)); }};
  const SearchLimits limits = {.relative_step = 1e-8, .relative_decrease = 1e-8, .most_evaluations = most_evaluations};
  static_cast<void>(search_least_squares(problem, limits, logarithms));
  logarithms = logarithms.cwiseMax(least).cwiseMin(most);
}

std::vector<PronySeries> CommonTimesFit::series(const Eigen::VectorXd& relaxation_times) const {
  const auto all = strengths(relaxation_times);
  std::vector<PronySeries> fitted;
  for (Eigen::Index i = 0; i < all.cols(); ++i) {
    std::vector<MaxwellTerm> terms;
    for (Eigen::Index k = 0; k < relaxation_times.size(); ++k) {
      if (all(k, i) > 0.0) terms.push_back({relaxation_times[k], all(k, i)});
    }
    fitted.emplace_back(all(relaxation_times.size(), i), std::move(terms));
  }
  return fitted;
}

}  // namespace breccia
