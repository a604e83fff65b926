#include "breccia/viscoelasticity/temperature_shift_fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "breccia/error.hpp"

#include "viscoelasticity/least_squares.hpp"

namespace breccia {
namespace {

/// The deviations of log10 a_T from -S d / (1 + k d) with d = T - T_ref. The unknowns, the slope S = c1 / c2 at the
/// reference and the curvature k = 1 / c2, remain finite for factors nearly linear in T, where c1 and c2 diverge.
class Deviations {
 public:
  Deviations(Eigen::VectorXd differences, Eigen::VectorXd factors)
      : differences_(std::move(differences)), factors_(std::move(factors)) {}

  void set_deviations(const Eigen::VectorXd& x, Eigen::VectorXd& deviations) const {
    for (Eigen::Index i = 0; i < factors_.size(); ++i) {
      const double reach = 1.0 + x[1] * differences_[i];
      // A trial with its pole among the data is rejected by a large deviation.
      constexpr double forbidden = 1e6;
      deviations[i] = reach > 0.0 ? -x[0] * differences_[i] / reach - factors_[i] : forbidden;
    }
  }

  void set_jacobian(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian) const {
    for (Eigen::Index i = 0; i < factors_.size(); ++i) {
      const double d = differences_[i], reach = 1.0 + x[1] * d;
      jacobian(i, 0) = -d / reach;
      jacobian(i, 1) = x[0] * d * d / (reach * reach);
    }
  }

 private:
  Eigen::VectorXd differences_;  ///< T - T_ref [K]
  Eigen::VectorXd factors_;      ///< log10 a_T
};

}  // namespace

std::optional<WilliamsLandelFerryFit> fit_williams_landel_ferry(std::span<const ShiftFactor> factors,
                                                                double reference_temperature) {
  std::vector<ShiftFactor> used;
  std::ranges::copy_if(factors, std::back_inserter(used),
                       [&](const ShiftFactor& factor) { return factor.temperature != reference_temperature; });
  const auto count = static_cast<Eigen::Index>(used.size());
  std::set<double> temperatures;
  for (const auto& factor : used) temperatures.insert(factor.temperature);
  if (temperatures.size() < 2) throw InputError("WLF fit: expected at least two temperatures beside the reference");
  Eigen::VectorXd differences(count), logarithms(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    differences[i] = used[static_cast<std::size_t>(i)].temperature - reference_temperature;
    logarithms[i] = used[static_cast<std::size_t>(i)].log10_factor;
  }
  const double mean_slope = -differences.dot(logarithms) / differences.squaredNorm();
  if (!(mean_slope > 0.0)) throw InputError("WLF fit: the shift factors do not fall as the temperature rises");

  // The start is a nearly linear law, whose pole is far from all data.
  const double furthest = differences.cwiseAbs().maxCoeff();
  Eigen::VectorXd x(2);
  x << mean_slope, 0.01 / furthest;
  const Deviations deviations(differences, logarithms);
  const NonlinearLeastSquares problem = {
      .values = count,
      .deviations = [&](const auto& at, auto& f) { deviations.set_deviations(at, f); },
      .jacobian = [&](const auto& at, auto& jacobian) { deviations.set_jacobian(at, jacobian); }};
  if (!search_least_squares(problem, {.relative_step = 1e-12, .relative_decrease = 1e-14}, x)) {
    throw NumericalError("WLF fit: the constants do not converge");
  }

  // A smaller curvature cannot be distinguished from zero: c2 would be a thousand times the range of the data.
  constexpr double least_bend = 1e-3;
  if (!(x[0] > 0.0) || !(x[1] * furthest > least_bend)) return std::nullopt;
  const double c2 = 1.0 / x[1], c1 = x[0] * c2;
  WilliamsLandelFerryFit fit{{c1, c2, reference_temperature}};
  Eigen::VectorXd residual(count);
  Eigen::MatrixXd jacobian(count, 2);
  deviations.set_deviations(x, residual);
  deviations.set_jacobian(x, jacobian);
  Eigen::Index worst = 0;
  fit.worst_deviation = residual.cwiseAbs().maxCoeff(&worst);
  fit.worst_at = used[static_cast<std::size_t>(worst)].temperature;
  if (count > 2) {
    if (!variances(jacobian)) throw NumericalError("WLF fit: the shift factors do not determine c1 and c2 separately");
    const double variance = residual.squaredNorm() / static_cast<double>(count - 2);
    const Eigen::Matrix2d covariance = variance * (jacobian.transpose() * jacobian).inverse();
    const Eigen::Vector2d c1_gradient(c2, -c1 * c2);
    fit.c1_error = std::sqrt(c1_gradient.dot(covariance * c1_gradient));
    fit.c2_error = c2 * c2 * std::sqrt(covariance(1, 1));
  }
  return fit;
}

bool follow(const WilliamsLandelFerryFit& fit) {
  constexpr double most_decades = 0.1;
  const bool is_determined = fit.c1_error > 0.0 && fit.c1_error < fit.law.c1;
  return is_determined && fit.worst_deviation <= most_decades;
}

std::optional<ShiftLaw> shift_law_of(const MasterCurve& curve) {
  const auto& factors = curve.shift_factors;
  const bool do_fall = std::ranges::adjacent_find(factors, [](const ShiftFactor& one, const ShiftFactor& next) {
                         return next.log10_factor >= one.log10_factor;
                       }) == factors.end();
  constexpr std::size_t fewest_of_law = 4, fewest = 2;
  if (!do_fall || factors.size() < fewest) return std::nullopt;
  if (factors.size() >= fewest_of_law) {
    try {
      const auto fit = fit_williams_landel_ferry(factors, curve.reference_temperature);
      if (fit && follow(*fit)) return fit->law;
    } catch (const NumericalError&) {
      // The factors do not determine a law, so that the table is returned.
    }
  }
  std::vector<double> temperatures, logarithms;
  for (const auto& factor : factors) {
    temperatures.push_back(factor.temperature);
    logarithms.push_back(factor.log10_factor);
  }
  return ShiftTable(std::move(temperatures), std::move(logarithms), curve.reference_temperature);
}

}  // namespace breccia
