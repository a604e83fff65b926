#include "breccia/dynamics/dynamic_solver.hpp"

#include <algorithm>
#include <cmath>
#include <span>
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
  // Few enough for what grows without bound to be found where it began, and before it is infinite.
  constexpr int steps_between_looks = 256;
  for (int taken = 0; taken < steps; taken += steps_between_looks) {
    const auto now = static_cast<std::size_t>(std::min(steps - taken, steps_between_looks));
    const auto before = averages.size();
    averages.resize(before + now);
    take_steps(step_, static_cast<int>(now), averages.data() + before);
    require_sound(std::span(averages).subspan(before));
    step_ += static_cast<std::int64_t>(now);
  }
}

double DynamicSolver::largest_sound_stress() const {
  // Whatever rings, or moves before the load: no average stress of a stable run comes near this.
  constexpr double many = 1e4;
  double stiffest = 1.0;
  for (const auto& material : problem_.materials) {
    stiffest = std::max(stiffest, material.bulk.unrelaxed() + 4.0 / 3.0 * material.shear.unrelaxed());
  }
  return many * stiffest;
}

void DynamicSolver::require_sound(std::span<const Averages> averages) const {
  const double largest = largest_sound_stress();
  const auto is_sound = [&](const Averages& a) {
    const double sum = std::abs(a.stress.xx) + std::abs(a.stress.yy) + std::abs(a.stress.xy);
    const double strain = a.strain.xx + a.strain.yy + a.strain.xy;
    return sum <= largest && std::isfinite(strain);
  };
  const auto bad = std::ranges::find_if_not(averages, is_sound);
  if (bad == averages.end()) return;
  const auto step = step_ + (bad - averages.begin());
  const auto place = most_moved();
  throw NumericalError(fmt::format(
      "dynamic run: unstable at step {}, {:.3e} s after the load: an average stress of {:.1e} Pa for a load of "
      "one, and the fastest motion at ({:.4g}, {:.4g}) m; likely cause: a time step above the stable limit "
      "(a smaller tests.dynamic.courant), or moduli that differ by more than numbers hold",
      step, time_at(step), std::abs(bad->stress.xx) + std::abs(bad->stress.yy) + std::abs(bad->stress.xy), place[0],
      place[1]));
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
