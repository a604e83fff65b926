#include "quasistatic/reduced/response_gradient.hpp"

#include <algorithm>
#include <cstddef>

namespace breccia {

ValueAndGradient compliance_and_gradient(const ReducedResponse& response, std::span<const Moduli> of_phases) {
  const auto parameters = response.parameters(of_phases);
  const Eigen::VectorXd solution = response.stiffness(parameters).ldlt().solve(response.load_forces);
  const auto phases = response.phases();
  ValueAndGradient found{response.load_forces.dot(solution), std::vector<Moduli>(phases.size())};
  for (const auto& [parameter, stiffness] : response.parts) {
    const auto phase = std::ranges::find(phases, parameter.phase) - phases.begin();
    auto& by_moduli = found.gradient[static_cast<std::size_t>(phase)];
    (parameter.modulus == ElasticModulus::shear ? by_moduli.shear : by_moduli.bulk) =
        -solution.dot(stiffness * solution);
  }
  return found;
}

ValueAndGradient modulus_and_gradient(const ReducedResponse& response, std::span<const Moduli> of_phases) {
  auto found = compliance_and_gradient(response, of_phases);
  const double modulus = 1.0 / found.value;
  for (auto& [by_bulk, by_shear] : found.gradient) {
    by_bulk *= -modulus * modulus;
    by_shear *= -modulus * modulus;
  }
  found.value = modulus;
  return found;
}

}  // namespace breccia
