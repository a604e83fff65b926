#include "breccia/quasistatic/reduced_response.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "network.hpp"

namespace breccia {
namespace {

/// s M~(s) = M_inf + sum_k M_k s tau_k / (1 + s tau_k)
double carson_modulus(const PronySeries& series, double s) {
  double modulus = series.equilibrium();
  for (const auto& [time, strength] : series.terms()) modulus += strength * s * time / (1.0 + s * time);
  return modulus;
}

Eigen::VectorXd reduced_solution(const ReducedResponse& response, const Moduli& matrix) {
  return (response.filler + matrix.shear * response.matrix_shear + matrix.bulk * response.matrix_bulk)
      .ldlt()
      .solve(response.load_forces);
}

/// 1 / (p + q G) is the compliance of a solid with the relaxation modulus p + q G(t).
PronySeries combined(double p, double q, const PronySeries& series) {
  auto terms = series.terms();
  for (auto& term : terms) term.modulus *= q;
  return {p + q * series.equilibrium(), std::move(terms)};
}

/// With an elastic bulk modulus the compliance is a sum of simple poles in G (theory, Eq. 19).
CreepCompliance sum_of_poles(const ReducedResponse& response, double bulk, const PronySeries& shear) {
  const Eigen::MatrixXd fixed = response.filler + bulk * response.matrix_bulk;
  // The basis is orthonormal for the matrix of the first snapshot.
  const double reference = response.snapshots.front().matrix.shear;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(fixed,
                                                                        fixed + reference * response.matrix_shear);
  double instantaneous = 0.0, fluidity = 0.0;
  std::vector<RetardationTerm> terms;
  for (Eigen::Index k = 0; k < modes.eigenvalues().size(); ++k) {
    const double share = std::clamp(modes.eigenvalues()[k], 0.0, 1.0);
    const double amplitude = modes.eigenvectors().col(k).dot(response.load_forces);
    const auto mode = creep_compliance(combined(share, (1.0 - share) / reference, shear));
    instantaneous += amplitude * amplitude * mode.instantaneous();
    fluidity += amplitude * amplitude * mode.fluidity();
    for (auto [time, strength] : mode.terms()) terms.push_back({time, amplitude * amplitude * strength});
  }
  return {instantaneous, std::move(terms), fluidity};
}

}  // namespace

double ReducedResponse::modulus(const Moduli& matrix) const {
  return 1.0 / load_forces.dot(reduced_solution(*this, matrix));
}

double ReducedResponse::error_estimate(const Moduli& matrix) const {
  const Eigen::VectorXd weights = reduced_solution(*this, matrix);
  Eigen::VectorXd residual(residual_products.rows());
  residual << weights, matrix.shear * weights, matrix.bulk * weights, -1.0;
  const double squared = std::max(0.0, residual.dot(residual_products * residual));
  // The error of e' K^-1 e is r' K^-1 r. What is left of r is held by the matrix, as stiff as its shear modulus.
  return residual_scale * squared / (matrix.shear * load_forces.dot(weights));
}

CreepCompliance creep_compliance(const ReducedResponse& response, const Material& matrix) {
  if (matrix.bulk.is_elastic()) return sum_of_poles(response, matrix.bulk.equilibrium(), matrix.shear);
  return quasistatic::network_compliance(response, matrix);
}

std::vector<Moduli> carson_path(const Material& material, const TimeWindow& window, double margin) {
  constexpr double per_decade = 8.0, least_change = 0.05, rounding = 1e-9;
  const double first = margin / window.begin, last = 1.0 / (margin * window.end);
  const auto at = [&](double s) { return Moduli{carson_modulus(material.bulk, s), carson_modulus(material.shear, s)}; };
  std::vector<Moduli> path = {at(first)};
  const int count = static_cast<int>(std::ceil(per_decade * std::log10(first / last)));
  for (int i = 1; i <= count; ++i) {
    const auto moduli = at(first * std::pow(last / first, static_cast<double>(i) / count));
    // The bulk modulus of a stage's result may rise while the shear modulus falls.
    const double change =
        std::max(std::abs(moduli.bulk / path.back().bulk - 1.0), std::abs(moduli.shear / path.back().shear - 1.0));
    if (change > least_change || (i == count && change > rounding)) path.push_back(moduli);
  }
  return path;
}

double require_sampled(const ReducedResponse& response, const Material& matrix, const TimeWindow& window) {
  Moduli least = response.snapshots.front().matrix, most = least;
  for (const auto& [moduli, error] : response.snapshots) {
    least = {std::min(least.bulk, moduli.bulk), std::min(least.shear, moduli.shear)};
    most = {std::max(most.bulk, moduli.bulk), std::max(most.shear, moduli.shear)};
  }
  // A bulk modulus off the sampled path costs little: the matrix is nearly incompressible, or its volume matters
  // little.
  constexpr double rounding = 1e-9, off_path = 0.1;
  // What was sampled reaches well beyond the times of the run; a new matrix must stay inside for its own times alone.
  constexpr double margin = 1.0;
  double error = 0.0;
  for (const auto& [bulk, shear] : carson_path(matrix, window, margin)) {
    const auto refuse = [&](const char* modulus, double value, double from, double to) {
      throw InputError(
          fmt::format("{}: a {} modulus of {:.4g} Pa, which it shows between {:.3g} and {:.3g} s, lies outside the "
                      "range from {:.4g} to {:.4g} Pa in which the response was sampled",
                      matrix.name, modulus, value, window.begin, window.end, from, to));
    };
    if (shear < (1.0 - rounding) * least.shear || shear > (1.0 + rounding) * most.shear) {
      refuse("shear", shear, least.shear, most.shear);
    }
    if (bulk < (1.0 - off_path) * least.bulk || bulk > (1.0 + off_path) * most.bulk) {
      refuse("bulk", bulk, (1.0 - off_path) * least.bulk, (1.0 + off_path) * most.bulk);
    }
    error = std::max(error, response.error_estimate({bulk, shear}));
  }
  return error;
}

}  // namespace breccia
