#include "quasistatic/reduced/response_gradient.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <utility>

#include <Eigen/Core>
#include <fmt/format.h>

#include "breccia/error.hpp"

#include "quasistatic/lapack.hpp"

namespace breccia {
namespace {

/// The solution of a system whose matrix is symmetric but not Hermitian, by its lower triangle. The matrices are small:
/// the call that takes a workspace saves half of the time.
Eigen::VectorXcd symmetric_solution(Eigen::MatrixXcd matrix, Eigen::VectorXcd right_side) {
  const auto size = static_cast<lapack_int>(matrix.rows());
  std::vector<lapack_int> pivots(static_cast<std::size_t>(size));
  Eigen::VectorXcd workspace(size);
  const auto failed = LAPACKE_zsysv_work(LAPACK_COL_MAJOR, 'L', size, 1, matrix.data(), size, pivots.data(),
                                         right_side.data(), size, workspace.data(), size);
  if (failed != 0) {
    throw NumericalError("reduced response: the stiffness at a Laplace variable is singular");
  }
  return right_side;
}

}  // namespace

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
  const auto solution = symmetric_solution(std::move(stiffness), response.load_forces.cast<std::complex<double>>());
  // Products are those of the transpose, not of the adjoint.
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
