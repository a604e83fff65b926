#include "breccia/quasistatic/reduced_response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "reduced/network.hpp"
#include "reduced/residual_rounding.hpp"

namespace breccia {
namespace {

Eigen::VectorXd reduced_solution(const ReducedResponse& response, std::span<const double> parameters) {
  return response.stiffness(parameters).ldlt().solve(response.load_forces);
}

/// Weights of the parts of the residual: of K_0 v for all vectors v, of K_i v for each part, and of the load.
Eigen::VectorXd residual_weights(const Eigen::VectorXd& solution, std::span<const double> parameters) {
  const auto size = solution.size();
  Eigen::VectorXd weights((static_cast<Eigen::Index>(parameters.size()) + 1) * size + 1);
  weights.head(size) = solution;
  Eigen::Index row = size;
  for (const double parameter : parameters) {
    weights.segment(row, size) = parameter * solution;
    row += size;
  }
  weights[row] = -1.0;
  return weights;
}

/// The part of the residual that the basis leaves is held by the phases that vary: the softest of them has this shear
/// modulus [Pa].
double softest_shear(const ReducedResponse& response, std::span<const double> parameters) {
  double softest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (response.parts[i].parameter.modulus == ElasticModulus::shear) softest = std::min(softest, parameters[i]);
  }
  return softest;
}

/// 1 / (p + q G) is the compliance of a solid with the relaxation modulus p + q G(t).
PronySeries combined(double p, double q, const PronySeries& series) {
  auto terms = series.terms();
  for (auto& term : terms) term.modulus *= q;
  return {p + q * series.equilibrium(), std::move(terms)};
}

/// With an elastic bulk modulus the compliance is a sum of simple poles in G (theory, Eq. 19).
CreepCompliance sum_of_poles(const ReducedResponse& response, double bulk, const PronySeries& shear) {
  const Eigen::MatrixXd fixed = response.constant + bulk * response.part(ElasticModulus::bulk);
  // The basis is orthonormal for the matrix of the first snapshot.
  const double reference = response.snapshots.front().matrix.shear;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      fixed, fixed + reference * response.part(ElasticModulus::shear));
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

std::vector<AffinePart> matrix_parts(Eigen::MatrixXd shear, Eigen::MatrixXd bulk) {
  const std::string phase(name_of_matrix_phase);
  return {{{phase, ElasticModulus::shear}, std::move(shear)}, {{phase, ElasticModulus::bulk}, std::move(bulk)}};
}

const Eigen::MatrixXd& ReducedResponse::part(ElasticModulus modulus) const {
  const PhaseModulus wanted = {std::string(name_of_matrix_phase), modulus};
  const auto found = std::ranges::find(parts, wanted, &AffinePart::parameter);
  if (found == parts.end()) throw InputError("reduced response: no part of its stiffness belongs to the matrix");
  return found->stiffness;
}

std::vector<double> ReducedResponse::parameters(const Moduli& matrix) const {
  std::vector<double> parameters;
  parameters.reserve(parts.size());
  for (const auto& [parameter, stiffness] : parts) {
    if (parameter.phase != name_of_matrix_phase) {
      throw InputError(
          fmt::format("reduced response: the moduli of {} vary too, not those of the matrix alone", parameter.phase));
    }
    parameters.push_back(parameter.modulus == ElasticModulus::shear ? matrix.shear : matrix.bulk);
  }
  return parameters;
}

Eigen::MatrixXd ReducedResponse::stiffness(std::span<const double> parameters) const {
  Eigen::MatrixXd sum = constant;
  for (std::size_t i = 0; i < parts.size(); ++i) sum += parameters[i] * parts[i].stiffness;
  return sum;
}

double ReducedResponse::modulus(std::span<const double> parameters) const {
  return 1.0 / load_forces.dot(reduced_solution(*this, parameters));
}

double ReducedResponse::modulus(const Moduli& matrix) const {
  return modulus(parameters(matrix));
}

double ReducedResponse::error_estimate(std::span<const double> parameters) const {
  const Eigen::VectorXd solution = reduced_solution(*this, parameters);
  const auto residual = residual_weights(solution, parameters);
  const double squared = std::max(0.0, residual.dot(residual_products * residual));
  // The error of e' K^-1 e is r' K^-1 r.
  return residual_scale * squared / (softest_shear(*this, parameters) * load_forces.dot(solution));
}

double ReducedResponse::error_estimate(const Moduli& matrix) const {
  return error_estimate(parameters(matrix));
}

double quasistatic::rounding_of_error_estimate(const ReducedResponse& response, const Moduli& matrix) {
  constexpr double of_a_sum = 4e-16;
  const auto parameters = response.parameters(matrix);
  const auto solution = reduced_solution(response, parameters);
  const Eigen::VectorXd weights = residual_weights(solution, parameters).cwiseAbs();
  const double squared = of_a_sum * weights.dot(response.residual_products.cwiseAbs() * weights);
  return response.residual_scale * squared / (softest_shear(response, parameters) * response.load_forces.dot(solution));
}

CreepCompliance creep_compliance(const ReducedResponse& response, const Material& matrix) {
  if (matrix.bulk.is_elastic()) return sum_of_poles(response, matrix.bulk.equilibrium(), matrix.shear);
  return quasistatic::network_compliance(response, matrix);
}

}  // namespace breccia
