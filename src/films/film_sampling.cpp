#include "films/film_sampling.hpp"

#include <memory>

#include "checkpoint/checkpoint.hpp"
#include "films/fields/film_recovery.hpp"
#include "films/film_composite.hpp"
#include "quasistatic/reduced/greedy_sampling.hpp"

namespace breccia {
namespace {

/// Grains and films and the reduced bases that point to them.
struct SampledFilms {
  SampledFilms(const FilmProblem<2>& problem, std::span<const Load> loads, const TrainingPath& path)
      : composite(problem), sampling(composite, loads, quasistatic::initial_snapshots(path).front()) {}

  films::FilmComposite<2> composite;
  quasistatic::GreedySampling<films::FilmComposite<2>> sampling;
};

}  // namespace

FilmResponses sample_film_responses(const FilmProblem<2>& problem, std::span<const Load> loads,
                                    std::span<const Moduli> training_set, const SamplingOptions& options,
                                    const ProgressObserver& observer, Checkpoint* checkpoint,
                                    const std::optional<TargetCurve>& target) {
  constexpr PhaseIndex binder = 0;
  auto path = matrix_path(binder, training_set);
  path.target = target;
  quasistatic::require_complete(loads, path);
  const auto sampled = std::make_shared<SampledFilms>(problem, loads, path);
  auto& sampling = sampled->sampling;
  films::FilmSolver<2> solver(sampled->composite);
  if (const auto* earlier = checkpoint != nullptr ? checkpoint->earlier() : nullptr) {
    sampling.restore(*earlier);
    solver.count_from(sampling.effort());
  }
  quasistatic::sample(sampling, solver, path, options, observer, checkpoint);
  return {.responses = sampling.responses(),
          .effort = solver.effort(),
          .fields = [sampled, problem](std::size_t load, std::span<const Material> materials, double time) {
            const auto& basis = sampled->sampling.bases().at(load);
            return films::fields_of(sampled->composite, problem, basis.load(), basis.state(materials, time));
          }};
}

}  // namespace breccia
