#include "quasistatic/reduced/response_gradient.hpp"

#include <algorithm>
#include <cstddef>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

ValueAndGradient compliance_and_gradient(const ReducedResponse& response, std::span<const ComplexModuli> of_phases) {
  const auto phases = response.phases();
  if (of_phases.size() != phases.size()) {
    throw InputError(
        fmt::format("reduced response: expected moduli of {} phases, got {}", phases.size(), of_phases.size()));
  }
  const auto phase_of = [&phases](const AffinePart& part) {
    return static_cast<std::size_t>(std::ranges::find(phases, part.parameter.phase) - phases.begin());
  };
  Eigen::MatrixXcd stiffness = response.constant.cast<std::complex<double>>();
  for (const auto& part : response.parts) {
    const auto& moduli = of_phases[phase_of(part)];
    stiffness += (part.parameter.modulus == ElasticModulus::shear ? moduli.shear : moduli.bulk) * part.stiffness;
  }
  // The matrix is symmetric but not Hermitian: products are those of the transpose.
  const Eigen::VectorXcd solution = stiffness.partialPivLu().solve(response.load_forces.cast<std::complex<double>>());
  ValueAndGradient found{response.load_forces.transpose() * solution, std::vector<ComplexModuli>(phases.size())};
  for (const auto& part : response.parts) {
    auto& by_moduli = found.gradient[phase_of(part)];
    (part.parameter.modulus == ElasticModulus::shear ? by_moduli.shear : by_moduli.bulk) =
        -(solution.transpose() * (part.stiffness * solution)).value();
  }
  return found;
}

ValueAndGradient modulus_and_gradient(const ReducedResponse& response, std::span<const ComplexModuli> of_phases) {
  auto found = compliance_and_gradient(response, of_phases);
  const auto modulus = 1.0 / found.value;
  for (auto& [by_bulk, by_shear] : found.gradient) {
    by_bulk *= -modulus * modulus;
    by_shear *= -modulus * modulus;
  }
  found.value = modulus;
  return found;
}

}  // namespace breccia
