#include "quasistatic/reduced/sampling.hpp"

#include <memory>
#include <utility>

#include "checkpoint/checkpoint.hpp"
#include "quasistatic/operator/displacement_state.hpp"
#include "quasistatic/reduced/cell_composite.hpp"
#include "quasistatic/reduced/greedy_sampling.hpp"

namespace breccia {
namespace {

using quasistatic::CellComposite;
using quasistatic::CellSolver;
using quasistatic::GreedySampling;

/// A composite of cells and the reduced bases that point to it.
template <int dim>
struct SampledCells {
  SampledCells(const QuasistaticProblem<dim>& problem, std::span<const Load> loads, const TrainingPath& training_set)
      : composite(problem, training_set.phases),
        sampling(composite, loads, quasistatic::initial_snapshots(training_set).front()) {}

  CellComposite<dim> composite;
  GreedySampling<CellComposite<dim>> sampling;
};

}  // namespace

template <int dim>
SampledResponses<dim> sample_responses(const QuasistaticProblem<dim>& problem, std::span<const Load> loads,
                                       const TrainingPath& training_set, const SamplingOptions& options,
                                       const ProgressObserver& observer, Checkpoint* checkpoint) {
  quasistatic::require_complete(loads, training_set);
  require_loads("reduced basis", dim, loads);
  require_phases_in_cells("reduced basis", problem.discretisation, problem.materials.size());
  const auto sampled = std::make_shared<SampledCells<dim>>(problem, loads, training_set);
  CellSolver<dim> solver(sampled->composite, problem.linear);
  if (const auto* earlier = checkpoint != nullptr ? checkpoint->earlier() : nullptr) {
    sampled->sampling.restore(*earlier);
    solver.count_from(sampled->sampling.effort());
  }
  quasistatic::sample(sampled->sampling, solver, training_set, options, observer, checkpoint);
  return {.responses = sampled->sampling.responses(),
          .effort = solver.effort(),
          .fields = [sampled, problem](std::size_t load, std::span<const Material> of_phases, double time) {
            const auto& basis = sampled->sampling.bases().at(load);
            return quasistatic::fields_of(sampled->composite, problem, basis.load(), basis.state(of_phases, time));
          }};
}

template SampledResponses<2> sample_responses(const QuasistaticProblem<2>&, std::span<const Load>, const TrainingPath&,
                                              const SamplingOptions&, const ProgressObserver&, Checkpoint*);
template SampledResponses<3> sample_responses(const QuasistaticProblem<3>&, std::span<const Load>, const TrainingPath&,
                                              const SamplingOptions&, const ProgressObserver&, Checkpoint*);

}  // namespace breccia
