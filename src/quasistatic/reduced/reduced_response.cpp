#include "breccia/quasistatic/reduced_response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "quasistatic/reduced/network.hpp"
#include "quasistatic/reduced/part_series.hpp"
#include "quasistatic/reduced/residual_rounding.hpp"

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

/// The square of the norm of the residual.
double squared_residual(const ReducedResponse& response, const Eigen::VectorXd& solution,
                        std::span<const double> parameters) {
  const auto residual = residual_weights(solution, parameters);
  return std::max(0.0, residual.dot(response.residual_products * residual));
}

/// The least shear modulus [Pa] of the phases that vary, which bounds the stiffness against the residual of the basis
/// from below.
double softest_shear(const ReducedResponse& response, std::span<const double> parameters) {
  double softest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (response.parts[i].parameter.modulus == ElasticModulus::shear) softest = std::min(softest, parameters[i]);
  }
  return softest;
}

/// The relaxation modulus p + q G(t) of a solid with the compliance 1 / (p + q G).
PronySeries combined(double p, double q, const PronySeries& series) {
  auto terms = series.terms();
  for (auto& term : terms) term.modulus *= q;
  return {p + q * series.equilibrium(), std::move(terms)};
}

/// Index of the part whose modulus is the only one that relaxes, where that is a shear modulus. Where no modulus
/// relaxes, any shear modulus can be taken as the one that does.
std::optional<std::size_t> only_relaxing_shear(const ReducedResponse& response,
                                               const std::vector<const PronySeries*>& series) {
  std::vector<std::size_t> relaxing, in_shear;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (!series[i]->is_elastic()) relaxing.push_back(i);
    if (response.parts[i].parameter.modulus == ElasticModulus::shear) in_shear.push_back(i);
  }
  if (relaxing.empty() && !in_shear.empty()) return in_shear.front();
  if (relaxing.size() == 1 && std::ranges::find(in_shear, relaxing.front()) != in_shear.end()) return relaxing.front();
  return std::nullopt;
}

/// Where a single shear modulus relaxes, the compliance is a sum of simple poles in it (theory, Eq. 19).
CreepCompliance sum_of_poles(const ReducedResponse& response, std::size_t relaxing,
                             const std::vector<const PronySeries*>& series) {
  if (response.snapshots.empty()) {
    throw InputError("reduced response: it has no snapshot; expected the moduli for which its basis is orthonormal");
  }
  Eigen::MatrixXd fixed = response.constant;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (i != relaxing) fixed += series[i]->equilibrium() * response.parts[i].stiffness;
  }
  // The basis is orthonormal for the moduli of the first snapshot.
  const double reference = response.parameters(response.snapshots.front().moduli)[relaxing];
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      fixed, fixed + reference * response.parts[relaxing].stiffness);
  double instantaneous = 0.0, fluidity = 0.0;
  std::vector<RetardationTerm> terms;
  for (Eigen::Index k = 0; k < modes.eigenvalues().size(); ++k) {
    const double share = std::clamp(modes.eigenvalues()[k], 0.0, 1.0);
    const double amplitude = modes.eigenvectors().col(k).dot(response.load_forces);
    const auto mode = creep_compliance(combined(share, (1.0 - share) / reference, *series[relaxing]));
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

const Eigen::MatrixXd& ReducedResponse::part(const PhaseModulus& parameter) const {
  const auto found = std::ranges::find(parts, parameter, &AffinePart::parameter);
  if (found != parts.end()) return found->stiffness;
  throw InputError(fmt::format("reduced response: no part of its stiffness belongs to the {}", parameter.phase));
}

const Eigen::MatrixXd& ReducedResponse::part(ElasticModulus modulus) const {
  return part(PhaseModulus{std::string(name_of_matrix_phase), modulus});
}

std::vector<std::string> ReducedResponse::phases() const {
  std::vector<std::string> names;
  for (const auto& [parameter, stiffness] : parts) {
    if (std::ranges::find(names, parameter.phase) == names.end()) names.push_back(parameter.phase);
  }
  return names;
}

std::vector<double> ReducedResponse::parameters(std::span<const Moduli> of_phases) const {
  const auto names = phases();
  if (of_phases.size() != names.size()) {
    throw InputError(
        fmt::format("reduced response: expected moduli of {} phases, got {}", names.size(), of_phases.size()));
  }
  std::vector<double> parameters;
  parameters.reserve(parts.size());
  for (const auto& [parameter, stiffness] : parts) {
    const auto index = std::ranges::find(names, parameter.phase) - names.begin();
    const auto& [bulk, shear] = of_phases[static_cast<std::size_t>(index)];
    parameters.push_back(parameter.modulus == ElasticModulus::shear ? shear : bulk);
  }
  return parameters;
}

std::vector<double> ReducedResponse::parameters(const Moduli& matrix) const {
  for (const auto& name : phases()) {
    if (name == name_of_matrix_phase) continue;
    throw InputError(fmt::format("reduced response: the moduli of {} vary too, not those of the matrix alone", name));
  }
  return parameters(std::span(&matrix, 1));
}

std::vector<Material> ReducedResponse::materials(const std::map<std::string, Material>& by_phase) const {
  const auto names = phases();
  std::vector<std::string> mistakes;
  std::vector<Material> materials;
  for (const auto& name : names) {
    const auto material = by_phase.find(name);
    if (material == by_phase.end()) {
      mistakes.push_back(fmt::format("the phase {} has no material", name));
    } else {
      materials.push_back(material->second);
    }
  }
  for (const auto& [name, material] : by_phase) {
    if (std::ranges::find(names, name) != names.end()) continue;
    mistakes.push_back(
        fmt::format("{} is given for {}, expected one of the phases {}", material.name, name, fmt::join(names, ", ")));
  }
  if (!mistakes.empty()) throw InputError(fmt::format("reduced response: {}", fmt::join(mistakes, "; ")));
  return materials;
}

Eigen::MatrixXd ReducedResponse::stiffness(std::span<const double> parameters) const {
  Eigen::MatrixXd sum = constant;
  for (std::size_t i = 0; i < parts.size(); ++i) sum += parameters[i] * parts[i].stiffness;
  return sum;
}

double ReducedResponse::modulus(std::span<const double> parameters) const {
  return 1.0 / load_forces.dot(reduced_solution(*this, parameters));
}

double ReducedResponse::modulus(std::span<const Moduli> of_phases) const {
  return modulus(parameters(of_phases));
}

double ReducedResponse::modulus(const Moduli& matrix) const {
  return modulus(parameters(matrix));
}

double ReducedResponse::error_estimate(std::span<const double> parameters) const {
  const Eigen::VectorXd solution = reduced_solution(*this, parameters);
  // The error of e' K^-1 e is r' K^-1 r.
  return residual_scale * squared_residual(*this, solution, parameters) /
         (softest_shear(*this, parameters) * load_forces.dot(solution));
}

double ReducedResponse::error_estimate(std::span<const Moduli> of_phases) const {
  return error_estimate(parameters(of_phases));
}

double ReducedResponse::error_estimate(const Moduli& matrix) const {
  return error_estimate(parameters(matrix));
}

double quasistatic::rounding_of_error_estimate(const ReducedResponse& response, std::span<const Moduli> of_phases) {
  constexpr double of_a_sum = 4e-16;
  const auto parameters = response.parameters(of_phases);
  const auto solution = reduced_solution(response, parameters);
  const Eigen::VectorXd weights = residual_weights(solution, parameters).cwiseAbs();
  const double squared = of_a_sum * weights.dot(response.residual_products.cwiseAbs() * weights);
  return response.residual_scale * squared / (softest_shear(response, parameters) * response.load_forces.dot(solution));
}

bool quasistatic::has_residual_of_snapshot(const ReducedResponse& response, std::span<const Moduli> of_phases) {
  if (response.snapshots.empty()) return false;
  const auto distance = [of_phases](const Snapshot& snapshot) {
    double sum = 0.0;
    for (std::size_t phase = 0; phase < of_phases.size(); ++phase) {
      sum += std::abs(std::log(snapshot.moduli[phase].bulk / of_phases[phase].bulk));
      sum += std::abs(std::log(snapshot.moduli[phase].shear / of_phases[phase].shear));
    }
    return sum;
  };
  const auto nearest = std::ranges::min_element(response.snapshots, {}, distance);
  const auto squared_at = [&response](std::span<const Moduli> moduli) {
    const auto parameters = response.parameters(moduli);
    return squared_residual(response, reduced_solution(response, parameters), parameters);
  };
  return squared_at(of_phases) <= squared_at(nearest->moduli);
}

CreepCompliance creep_compliance(const ReducedResponse& response, std::span<const Material> of_phases) {
  const auto series = quasistatic::series_of_parts(response, of_phases);
  const auto relaxing = only_relaxing_shear(response, series);
  return relaxing ? sum_of_poles(response, *relaxing, series) : quasistatic::network_compliance(response, of_phases);
}

CreepCompliance creep_compliance(const ReducedResponse& response, const Material& matrix) {
  return creep_compliance(response, std::span(&matrix, 1));
}

}  // namespace breccia
