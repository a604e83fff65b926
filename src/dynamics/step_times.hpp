#pragma once

#include <cstdint>

#include "dynamics/dynamic_problem.hpp"

namespace breccia::dynamics {

/// Time of a step [s], counted from the midpoint of the ramp.
template <int dim>
[[nodiscard]] double time_at(const DynamicProblem<dim>& problem, std::int64_t step) noexcept {
  return static_cast<double>(step) * problem.time_step - 0.5 * problem.ramp.duration();
}

/// Share of the load that has been applied at a step; 0 at step 0 even where the ramp is a jump.
template <int dim>
[[nodiscard]] double load_at(const DynamicProblem<dim>& problem, std::int64_t step) noexcept {
  return step <= 0 ? 0.0 : problem.ramp.at(time_at(problem, step));
}

}  // namespace breccia::dynamics
