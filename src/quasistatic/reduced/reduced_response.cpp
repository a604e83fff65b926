#include "breccia/quasistatic/reduced_response.hpp"

#include <algorithm>
#include <cmath>

#include "breccia/viscoelasticity/interconversion.hpp"

#include "reduced/network.hpp"
#include "reduced/residual_rounding.hpp"

namespace breccia {
namespace {

Eigen::VectorXd reduced_solution(const ReducedResponse& response, const Moduli& matrix) {
  return (response.filler + matrix.shear * response.matrix_shear + matrix.bulk * response.matrix_bulk)
      .ldlt()
      .solve(response.load_forces);
}

/// The weights of the parts of the residual in it: of A v, B v and C v, and of the load.
Eigen::VectorXd residual_weights(const Eigen::VectorXd& solution, const Moduli& matrix) {
  Eigen::VectorXd weights(3 * solution.size() + 1);
  weights << solution, matrix.shear * solution, matrix.bulk * solution, -1.0;
  return weights;
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
  const auto residual = residual_weights(weights, matrix);
  const double squared = std::max(0.0, residual.dot(residual_products * residual));
  // The error of e' K^-1 e is r' K^-1 r. What is left of r is held by the matrix, as stiff as its shear modulus.
  return residual_scale * squared / (matrix.shear * load_forces.dot(weights));
}

double quasistatic::rounding_of_error_estimate(const ReducedResponse& response, const Moduli& matrix) {
  constexpr double rounding = 4e-16;
  const auto solution = reduced_solution(response, matrix);
  const Eigen::VectorXd weights = residual_weights(solution, matrix).cwiseAbs();
  const double squared = rounding * weights.dot(response.residual_products.cwiseAbs() * weights);
  return response.residual_scale * squared / (matrix.shear * response.load_forces.dot(solution));
}

CreepCompliance creep_compliance(const ReducedResponse& response, const Material& matrix) {
  if (matrix.bulk.is_elastic()) return sum_of_poles(response, matrix.bulk.equilibrium(), matrix.shear);
  return quasistatic::network_compliance(response, matrix);
}

}  // namespace breccia
