#include "breccia/films/film_sampling.hpp"

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/quasistatic/greedy_sampling.hpp"
#include "breccia/quasistatic/linear_effort_state.hpp"

#include "film_composite.hpp"

namespace breccia {

FilmResponses sample_film_responses(const FilmProblem& problem, std::span<const Load> loads,
                                    std::span<const Moduli> training_set, const SamplingOptions& options,
                                    const std::function<void(const SamplingProgress&)>& observer,
                                    Checkpoint* checkpoint) {
  constexpr PhaseIndex binder = 0;
  const auto path = matrix_path(binder, training_set);
  quasistatic::require_complete(loads, path);
  const films::FilmComposite composite(problem);
  films::FilmSolver solver(composite);
  quasistatic::GreedySampling sampling(composite, loads, quasistatic::initial_snapshots(path).front());
  if (const auto* earlier = checkpoint != nullptr ? checkpoint->earlier() : nullptr) {
    sampling.restore(*earlier);
    solver.count_from(read_effort(*earlier, "/effort"));
  }
  quasistatic::sample(sampling, solver, path, options, observer, checkpoint,
                      [&](StateWriter& state) { save(state, "/effort", solver.effort()); });
  return {.responses = sampling.responses(), .effort = solver.effort()};
}

}  // namespace breccia
