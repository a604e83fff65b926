#include "films/film_sampling.hpp"

#include <memory>
#include <optional>

#include "checkpoint/checkpoint.hpp"
#include "films/fields/film_recovery.hpp"
#include "films/film_composite.hpp"
#include "films/space/solid_recovery.hpp"
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
  std::optional<films::FilmRecovery<dim>> recovery = {};  ///< built for the first fields
};

}  // namespace

template <int dim>
FilmResponses<dim> sample_film_responses(const FilmProblem<dim>& problem, std::span<const Load> loads,
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
  const auto fields_at = [sampled, problem](std::size_t load, std::span<const Material> materials, double time) {
    const auto& basis = sampled->sampling.bases().at(load);
    auto& recovery = sampled->recovery;
    if (!recovery) recovery.emplace(sampled->composite, problem);
    return recovery->fields(basis.load(), basis.state(materials, time));
  };
  return {.responses = sampling.responses(), .effort = solver.effort(), .fields = fields_at};
}

template FilmResponses<2> sample_film_responses(const FilmProblem<2>&, std::span<const Load>, std::span<const Moduli>,
                                                const SamplingOptions&, const ProgressObserver&, Checkpoint*,
                                                const std::optional<TargetCurve>&);
template FilmResponses<3> sample_film_responses(const FilmProblem<3>&, std::span<const Load>, std::span<const Moduli>,
                                                const SamplingOptions&, const ProgressObserver&, Checkpoint*,
                                                const std::optional<TargetCurve>&);

}  // namespace breccia
