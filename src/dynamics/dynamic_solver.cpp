#include "dynamics/dynamic_solver.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "dynamics/boundary_nodes.hpp"
#include "dynamics/classical.hpp"
#include "dynamics/layer_exchange.hpp"
#include "dynamics/step_times.hpp"
#include "dynamics/total_lagrangian.hpp"
#include "parallel/session.hpp"
#include "parallel/threads.hpp"

namespace breccia {

template <int dim>
DynamicSolver<dim>::DynamicSolver(DynamicProblem<dim> problem) : problem_(std::move(problem)) {
  require_stable(problem_);
  dynamics::require_points_under_traction(problem_);
}

template <int dim>
double DynamicSolver<dim>::load_at(std::int64_t step) const noexcept {
  return dynamics::load_at(problem_, step);
}

template <int dim>
double DynamicSolver<dim>::time_at(std::int64_t step) const noexcept {
  return dynamics::time_at(problem_, step);
}

template <int dim>
void DynamicSolver<dim>::advance(int steps, std::vector<Averages<dim>>& averages) {
  // Number of steps between checks of the stability: small enough that an instability is found near its origin, and
  // before values are infinite.
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

template <int dim>
double DynamicSolver<dim>::largest_sound_stress() const {
  // A limit that no average stress of a stable run comes near, in spite of ringing and of motions before the load.
  constexpr double many = 1e4;
  double stiffest = 1.0;
  for (const auto& material : problem_.materials) {
    stiffest = std::max(stiffest, material.bulk.unrelaxed() + 4.0 / 3.0 * material.shear.unrelaxed());
  }
  return many * stiffest;
}

template <int dim>
void DynamicSolver<dim>::require_sound(std::span<const Averages<dim>> averages) const {
  const double largest = largest_sound_stress();
  const auto size = [](const auto& tensor) {
    double sum = 0.0;
    for (int i = 0; i < tensor_components<dim>; ++i) sum += std::abs(component(tensor, i));
    return sum;
  };
  const auto is_sound = [&](const Averages<dim>& a) {
    return size(a.stress) <= largest && std::isfinite(size(a.strain));
  };
  const auto bad = std::ranges::find_if_not(averages, is_sound);
  if (bad == averages.end()) return;
  const auto step = step_ + (bad - averages.begin());
  const auto position = most_moved();
  throw NumericalError(fmt::format(
      "dynamic run: unstable at step {}, {:.3e} s after the load: an average stress of {:.1e} Pa for a load of "
      "one, and the fastest motion at ({:.4g}) m; likely cause: a time step above the stable limit "
      "(a smaller tests.dynamic.courant), or moduli that differ by more than numbers hold",
      step, time_at(step), size(bad->stress), fmt::join(position, ", ")));
}

template <int dim>
void DynamicSolver<dim>::require_elastic() const {
  for (const auto& material : problem_.materials) {
    if (!material.bulk.is_elastic() || !material.shear.is_elastic()) {
      throw InputError(fmt::format("energy: defined for elastic materials only, but '{}' relaxes", material.name));
    }
  }
}

template class DynamicSolver<2>;
template class DynamicSolver<3>;

template <int dim>
std::unique_ptr<DynamicSolver<dim>> make_dynamic_solver(Formulation formulation, DynamicProblem<dim> problem,
                                                        int threads, InstructionSet instructions) {
  const int used = parallel::threads_for(threads);
  switch (formulation) {
    case Formulation::total_lagrangian:
      return std::make_unique<dynamics::TotalLagrangian<dim>>(std::move(problem), used, instructions);
    case Formulation::classical:
      return std::make_unique<dynamics::Classical<dim>>(std::move(problem), used);
  }
  throw InputError("dynamic run: unknown formulation");
}

template <int dim>
IndexRange<dim> own_cells(Formulation formulation, const Grid<dim>& grid) {
  if (formulation == Formulation::total_lagrangian) return dynamics::own_layers(grid);
  // In the other formulation every process computes the whole box.
  return parallel::rank() == 0 ? grid.all_cells() : IndexRange<dim>{};
}

template IndexRange<2> own_cells(Formulation, const Grid<2>&);
template IndexRange<3> own_cells(Formulation, const Grid<3>&);
template std::unique_ptr<DynamicSolver<2>> make_dynamic_solver(Formulation, DynamicProblem<2>, int, InstructionSet);
template std::unique_ptr<DynamicSolver<3>> make_dynamic_solver(Formulation, DynamicProblem<3>, int, InstructionSet);

}  // namespace breccia
