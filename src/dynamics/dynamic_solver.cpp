#include "breccia/dynamics/dynamic_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <omp.h>

#include "breccia/error.hpp"

#include "classical.hpp"
#include "total_lagrangian.hpp"

namespace breccia {

DynamicSolver::DynamicSolver(DynamicProblem problem) : problem_(std::move(problem)) {
  require_stable(problem_);
}

double DynamicSolver::load_at(std::int64_t step) const noexcept {
  return step <= 0 ? 0.0 : problem_.ramp.at(time_at(step));
}

double DynamicSolver::time_at(std::int64_t step) const noexcept {
  return static_cast<double>(step) * problem_.time_step - 0.5 * problem_.ramp.duration();
}

void DynamicSolver::advance(int steps, std::vector<PlaneStress>& stresses) {
  const auto before = stresses.size();
  stresses.resize(before + static_cast<std::size_t>(steps));
  take_steps(step_, steps, stresses.data() + before);
  const auto finite = [](const PlaneStress& s) { return std::isfinite(s.xx + s.yy + s.xy); };
  const auto bad = std::find_if_not(stresses.begin() + static_cast<std::ptrdiff_t>(before), stresses.end(), finite);
  if (bad != stresses.end()) {
    const auto step = step_ + (bad - stresses.begin()) - static_cast<std::ptrdiff_t>(before);
    throw NumericalError(
        fmt::format("dynamic run: the average stress is no longer finite at step {}, {:.3e} s after the "
                    "strain; likely cause: a time step above the stable limit",
                    step, time_at(step)));
  }
  step_ += steps;
}

void DynamicSolver::require_elastic() const {
  for (const auto& material : problem_.materials) {
    if (!material.bulk.is_elastic() || !material.shear.is_elastic()) {
      throw InputError(fmt::format("energy: defined for elastic materials only, but '{}' relaxes", material.name));
    }
  }
}

std::unique_ptr<DynamicSolver> make_dynamic_solver(Formulation formulation, DynamicProblem problem, int threads) {
  const int used = threads > 0 ? threads : omp_get_max_threads();
  switch (formulation) {
    case Formulation::total_lagrangian:
      return std::make_unique<dynamics::TotalLagrangian>(std::move(problem), used);
    case Formulation::classical:
      return std::make_unique<dynamics::Classical>(std::move(problem), used);
  }
  throw InputError("dynamic run: unknown formulation");
}

}  // namespace breccia
