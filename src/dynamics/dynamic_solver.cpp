#include "breccia/dynamics/dynamic_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <omp.h>

#include "breccia/error.hpp"

#include "boundary_nodes.hpp"
#include "classical.hpp"
#include "total_lagrangian.hpp"

namespace breccia {

DynamicSolver::DynamicSolver(DynamicProblem problem) : problem_(std::move(problem)) {
  require_stable(problem_);
  dynamics::require_points_under_traction(problem_);
}

double DynamicSolver::load_at(std::int64_t step) const noexcept {
  return step <= 0 ? 0.0 : problem_.ramp.at(time_at(step));
}

double DynamicSolver::time_at(std::int64_t step) const noexcept {
  return static_cast<double>(step) * problem_.time_step - 0.5 * problem_.ramp.duration();
}

void DynamicSolver::advance(int steps, std::vector<Averages>& averages) {
  const auto before = averages.size();
  averages.resize(before + static_cast<std::size_t>(steps));
  take_steps(step_, steps, averages.data() + before);
  const auto finite = [](const Averages& a) { return std::isfinite(a.stress.xx + a.stress.yy + a.stress.xy); };
  const auto bad = std::find_if_not(averages.begin() + static_cast<std::ptrdiff_t>(before), averages.end(), finite);
  if (bad != averages.end()) {
    const auto step = step_ + (bad - averages.begin()) - static_cast<std::ptrdiff_t>(before);
    throw NumericalError(
        fmt::format("dynamic run: the average stress is no longer finite at step {}, {:.3e} s after the "
                    "load; likely cause: a time step above the stable limit",
                    step, time_at(step)));
  }
  step_ += steps;
}

void DynamicSolver::save(StateWriter& state, const std::string& group) const {
  state.write(group + "/step", step_);
  save_arrays(state, group);
}

void DynamicSolver::restore(const StateReader& state, const std::string& group) {
  step_ = state.integer(group + "/step");
  restore_arrays(state, group);
}

void DynamicSolver::require_elastic() const {
  for (const auto& material : problem_.materials) {
    if (!material.bulk.is_elastic() || !material.shear.is_elastic()) {
      throw InputError(fmt::format("energy: defined for elastic materials only, but '{}' relaxes", material.name));
    }
  }
}

std::unique_ptr<DynamicSolver> make_dynamic_solver(Formulation formulation, DynamicProblem problem, int threads,
                                                   InstructionSet instructions) {
  const int used = threads > 0 ? threads : omp_get_max_threads();
  switch (formulation) {
    case Formulation::total_lagrangian:
      return std::make_unique<dynamics::TotalLagrangian>(std::move(problem), used, instructions);
    case Formulation::classical:
      return std::make_unique<dynamics::Classical>(std::move(problem), used);
  }
  throw InputError("dynamic run: unknown formulation");
}

}  // namespace breccia
