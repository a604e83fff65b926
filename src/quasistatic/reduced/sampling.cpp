#include "breccia/quasistatic/sampling.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/quasistatic/greedy_sampling.hpp"
#include "breccia/quasistatic/linear_effort_state.hpp"

#include "operator/displacement_state.hpp"
#include "operator/recovery.hpp"
#include "reduced/cell_composite.hpp"
#include "reduced/network.hpp"

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

template <int dim>
PointFields<dim> recover(const SampledCells<dim>& sampled, const QuasistaticProblem<dim>& problem, std::size_t load,
                         std::span<const Material> of_phases, double time) {
  const auto& basis = sampled.sampling.bases().at(load);
  const auto& stiffness = sampled.composite.stiffness();
  const auto state = quasistatic::network_state(basis.response(), of_phases, time);
  // The load forces e of the basis are those of the unit load over the square root of the area.
  const double unit = std::sqrt(sampled.composite.elastic_operator().volume());
  const auto combined = [&](const Eigen::VectorXd& weights) { return basis.combination(unit * weights); };
  const auto displacement = combined(state.displacement);
  std::vector<quasistatic::AppliedModuli> applied;
  for (const auto& [bulk, shear] : stiffness.constant) {
    applied.push_back({displacement.copy(), displacement.copy()});
    applied.back().bulk.scale(bulk);
    applied.back().shear.scale(shear);
  }
  for (std::size_t i = 0; i < stiffness.parts.size(); ++i) {
    const auto& part = stiffness.parts[i];
    auto& [bulk, shear] = applied[part.phase];
    (part.parameter.modulus == ElasticModulus::shear ? shear : bulk) = combined(state.applied[i]);
  }
  return quasistatic::recover_fields(sampled.composite.elastic_operator(), problem.discretisation, problem.volumetric,
                                     basis.load(), displacement, applied);
}

}  // namespace

template <int dim>
SampledResponses<dim> sample_responses(const QuasistaticProblem<dim>& problem, std::span<const Load> loads,
                                       const TrainingPath& training_set, const SamplingOptions& options,
                                       const std::function<void(const SamplingProgress&)>& observer,
                                       Checkpoint* checkpoint) {
  quasistatic::require_complete(loads, training_set);
  require_loads("reduced basis", dim, loads);
  require_phases_in_cells("reduced basis", problem.discretisation, problem.materials.size());
  const auto sampled = std::make_shared<SampledCells<dim>>(problem, loads, training_set);
  CellSolver<dim> solver(sampled->composite, problem.linear);
  if (const auto* earlier = checkpoint != nullptr ? checkpoint->earlier() : nullptr) {
    quasistatic::require_as_many_processes(*earlier);
    sampled->sampling.restore(*earlier);
    solver.count_from(read_effort(*earlier, "/effort"));
  }
  quasistatic::sample(sampled->sampling, solver, training_set, options, observer, checkpoint, [&](StateWriter& state) {
    state.write("/processes", std::int64_t{parallel::ranks()});
    save(state, "/effort", solver.effort());
  });
  return {.responses = sampled->sampling.responses(),
          .effort = solver.effort(),
          .fields = [sampled, problem](std::size_t load, std::span<const Material> of_phases, double time) {
            return recover(*sampled, problem, load, of_phases, time);
          }};
}

template SampledResponses<2> sample_responses(const QuasistaticProblem<2>&, std::span<const Load>, const TrainingPath&,
                                              const SamplingOptions&,
                                              const std::function<void(const SamplingProgress&)>&, Checkpoint*);
template SampledResponses<3> sample_responses(const QuasistaticProblem<3>&, std::span<const Load>, const TrainingPath&,
                                              const SamplingOptions&,
                                              const std::function<void(const SamplingProgress&)>&, Checkpoint*);

}  // namespace breccia
