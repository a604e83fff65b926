#include "films/film_sampling.hpp"

#include <memory>

#include "checkpoint/checkpoint.hpp"
#include "films/fields/film_recovery.hpp"
#include "films/film_composite.hpp"
#include "quasistatic/reduced/greedy_sampling.hpp"

namespace breccia {
namespace {

/// Grains and films and the reduced bases that point to them.
template <int dim>
struct SampledFilms {
  SampledFilms(const FilmProblem<dim>& problem, std::span<const Load> loads, const TrainingPath& path)
      : composite(problem), sampling(composite, loads, quasistatic::initial_snapshots(path).front()) {}

  films::FilmComposite<dim> composite;
  quasistatic::GreedySampling<films::FilmComposite<dim>> sampling;
};

/// The fields of the sampled grains and films of the plane; nothing in space.
FilmResponses::Recovery recovery_of(const std::shared_ptr<SampledFilms<2>>& sampled, const FilmProblem<2>& problem) {
  return [sampled, problem](std::size_t load, std::span<const Material> materials, double time) {
    const auto& basis = sampled->sampling.bases().at(load);
    return films::fields_of(sampled->composite, problem, basis.load(), basis.state(materials, time));
  };
}
FilmResponses::Recovery recovery_of(const std::shared_ptr<SampledFilms<3>>& /*sampled*/,
                                    const FilmProblem<3>& /*problem*/) {
  return {};
}

}  // namespace

template <int dim>
FilmResponses sample_film_responses(const FilmProblem<dim>& problem, std::span<const Load> loads,
                                    std::span<const Moduli> training_set, const SamplingOptions& options,
                                    const ProgressObserver& observer, Checkpoint* checkpoint,
                                    const std::optional<TargetCurve>& target) {
  constexpr PhaseIndex binder = 0;
  auto path = matrix_path(binder, training_set);
  path.target = target;
  quasistatic::require_complete(loads, path);
  const auto sampled = std::make_shared<SampledFilms<dim>>(problem, loads, path);
  auto& sampling = sampled->sampling;
  films::FilmSolver<dim> solver(sampled->composite);
  if (const auto* earlier = checkpoint != nullptr ? checkpoint->earlier() : nullptr) {
    sampling.restore(*earlier);
    solver.count_from(sampling.effort());
  }
  quasistatic::sample(sampling, solver, path, options, observer, checkpoint);
  return {.responses = sampling.responses(), .effort = solver.effort(), .fields = recovery_of(sampled, problem)};
}

template FilmResponses sample_film_responses(const FilmProblem<2>&, std::span<const Load>, std::span<const Moduli>,
                                             const SamplingOptions&, const ProgressObserver&, Checkpoint*,
                                             const std::optional<TargetCurve>&);
template FilmResponses sample_film_responses(const FilmProblem<3>&, std::span<const Load>, std::span<const Moduli>,
                                             const SamplingOptions&, const ProgressObserver&, Checkpoint*,
                                             const std::optional<TargetCurve>&);

}  // namespace breccia
