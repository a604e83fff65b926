#include "films/film_stepping.hpp"

#include <vector>

#include "films/fields/film_recovery.hpp"
#include "films/film_composite.hpp"
#include "films/space/solid_recovery.hpp"
#include "quasistatic/solvers/linear_effort_state.hpp"
#include "quasistatic/stepping/log_time_runs.hpp"

namespace breccia {

template <int dim>
FilmSteppingResult<dim> run_film_stepping(const FilmProblem<dim>& problem, const Material& binder,
                                          std::span<const Load> loads, std::span<const double> times,
                                          const ProgressObserver& observer, std::span<const double> field_times,
                                          Checkpoint* checkpoint) {
  quasistatic::require_steps(loads, times);
  const films::FilmComposite<dim> composite(problem);
  std::vector<const PronySeries*> series(composite.parameters().size());
  series[films::FilmComposite<dim>::shear] = &binder.shear;
  series[films::FilmComposite<dim>::bulk] = &binder.bulk;
  quasistatic::LogTimeRuns runs(composite, series, loads, times, field_times);
  // Fields are found when the factors are gone.
  const auto effort = [&] {
    films::FilmSolver<dim> solver(composite);
    if (const auto* earlier = checkpoint != nullptr ? checkpoint->earlier() : nullptr) {
      runs.restore(*earlier);
      solver.count_from(read_effort(*earlier, "/effort"));
    }
    quasistatic::take_all_steps(runs, solver, observer, checkpoint,
                                [&](StateWriter& state) { save(state, "/effort", solver.effort()); });
    return solver.effort();
  }();
  FilmSteppingResult<dim> result = {runs.responses(), {}, effort};
  if (runs.kept().empty()) return result;
  const films::FilmRecovery<dim> recovery(composite, problem);
  for (const auto& [time, state] : runs.kept()) {
    result.fields.push_back({time, recovery.fields(loads.front(), state)});
  }
  return result;
}

template FilmSteppingResult<2> run_film_stepping(const FilmProblem<2>&, const Material&, std::span<const Load>,
                                                 std::span<const double>, const ProgressObserver&,
                                                 std::span<const double>, Checkpoint*);
template FilmSteppingResult<3> run_film_stepping(const FilmProblem<3>&, const Material&, std::span<const Load>,
                                                 std::span<const double>, const ProgressObserver&,
                                                 std::span<const double>, Checkpoint*);

}  // namespace breccia
