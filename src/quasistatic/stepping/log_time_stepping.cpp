#include "quasistatic/stepping/log_time_stepping.hpp"

#include <fmt/format.h>

#include "quasistatic/operator/displacement_state.hpp"
#include "quasistatic/reduced/cell_composite.hpp"
#include "quasistatic/reduced/stiff_composite.hpp"
#include "quasistatic/solvers/linear_effort_state.hpp"
#include "quasistatic/stepping/log_time_runs.hpp"

namespace breccia {
namespace {

/// All phases except crystals and voids, so that any of them may relax.
template <int dim>
std::vector<VaryingPhase> isotropic_phases(const QuasistaticProblem<dim>& problem) {
  std::vector<VaryingPhase> phases;
  for (std::size_t m = 0; m < problem.materials.size(); ++m) {
    const auto phase = static_cast<PhaseIndex>(m);
    if (!problem.crystals.contains(phase) && !is_void(problem.materials[m]))
      phases.push_back({phase, fmt::format("phase {}", m)});
  }
  return phases;
}

/// The relaxation moduli of the parts of a composite.
template <int dim>
std::vector<const PronySeries*> series_of(const quasistatic::CellComposite<dim>& composite,
                                          const std::vector<Material>& materials) {
  std::vector<const PronySeries*> series;
  for (const auto& part : composite.stiffness().parts) {
    const auto& material = materials[part.phase];
    series.push_back(part.parameter.modulus == ElasticModulus::shear ? &material.shear : &material.bulk);
  }
  return series;
}

}  // namespace

template <int dim>
SteppingResult<dim> run_log_time_stepping(const QuasistaticProblem<dim>& problem, std::span<const Load> loads,
                                          std::span<const double> times, const ProgressObserver& observer,
                                          std::span<const double> field_times, Checkpoint* checkpoint) {
  quasistatic::require_steps(loads, times);
  require_loads("log-time stepping", dim, loads);
  require_phases_in_cells("log-time stepping", problem.discretisation, problem.materials.size());
  require_stiff(problem, loads);
  const quasistatic::CellComposite<dim> composite(problem, isotropic_phases(problem));
  const auto series = series_of(composite, problem.materials);
  quasistatic::CellSolver<dim> solver(composite, problem.linear);
  quasistatic::LogTimeRuns runs(composite, series, loads, times, field_times);
  if (const auto* earlier = checkpoint != nullptr ? checkpoint->earlier() : nullptr) {
    runs.restore(*earlier);
    solver.restore_preconditioner(*earlier, "/preparation");
    solver.count_from(read_effort(*earlier, "/effort"));
  }
  quasistatic::take_all_steps(runs, solver, observer, checkpoint, [&](StateWriter& state) {
    solver.save_preconditioner(state, "/preparation");
    save(state, "/effort", solver.effort());
  });
  SteppingResult<dim> result = {runs.responses(), {}, solver.effort()};
  for (const auto& [time, state] : runs.kept()) {
    result.fields.push_back({time, quasistatic::fields_of(composite, problem, loads.front(), state)});
  }
  return result;
}

template SteppingResult<2> run_log_time_stepping(const QuasistaticProblem<2>&, std::span<const Load>,
                                                 std::span<const double>, const ProgressObserver&,
                                                 std::span<const double>, Checkpoint*);
template SteppingResult<3> run_log_time_stepping(const QuasistaticProblem<3>&, std::span<const Load>,
                                                 std::span<const double>, const ProgressObserver&,
                                                 std::span<const double>, Checkpoint*);

}  // namespace breccia
