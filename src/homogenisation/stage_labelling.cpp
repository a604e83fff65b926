#include "stage_labelling.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "breccia/error.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/microstructure/ellipsoid_locator.hpp"
#include "breccia/microstructure/grain_locator.hpp"
#include "breccia/microstructure/particle_locator.hpp"

namespace breccia {
namespace {

/// Places in the grains of a tessellation have the phase of the filler, those in its films that of the matrix.
template <int dim>
Labelling<dim> labelling_of_grains(const Stage& stage, const LaguerreSites<dim>& sites, double film) {
  const auto phases = phases_of(stage);
  const auto matrix = phases.index_of(name_of_matrix_phase);
  const auto filler = phases.index_of(phase_of(stage, stage.fillers.front().material));
  const auto locator = std::make_shared<const GrainLocator<dim>>(Tessellation<dim>(sites), film);
  return [locator, matrix, filler](const Vector<dim>& position) -> PhaseAt {
    const auto place = locator->at(position);
    return {place.is_in_grain() ? filler : matrix, std::abs(place.depth)};
  };
}

/// Places in particles have the phases of their fillers, those in their coatings that of the coating.
template <int dim, class Locator, class Box>
Labelling<dim> labelling_of_particles(const Stage& stage, const Box& box) {
  const auto matrix = phases_of(stage).index_of(name_of_matrix_phase);
  auto of_fillers = phases_of_fillers(stage);
  const auto locator = std::make_shared<const Locator>(box);
  return [locator, matrix, of_fillers = std::move(of_fillers)](const Vector<dim>& position) -> PhaseAt {
    const auto [particle, distance] = locator->at(position);
    if (!particle) return {matrix, distance};
    const auto& [phase, coating, thickness] = of_fillers.at(locator->box().filler_of(*particle));
    if (distance <= 0.0) return {phase, -distance};
    if (distance <= thickness) return {coating, std::min(distance, thickness - distance)};
    return {matrix, distance - thickness};
  };
}

Labelling<3> labelling_of_stack(const Stage& stage, const LabelImage<3>& stack) {
  return [&stack, of_labels = phases_of_labels(stage)](const Vector<3>& position) -> PhaseAt {
    return {of_labels.at(stack.label_at(position)), 0.0};
  };
}

}  // namespace

std::vector<ParticlePhases> phases_of_fillers(const Stage& stage) {
  const auto phases = phases_of(stage);
  std::vector<ParticlePhases> of_fillers;
  for (const auto& filler : stage.fillers) {
    auto& of_filler = of_fillers.emplace_back(ParticlePhases{phases.index_of(phase_of(stage, filler.material))});
    if (!filler.coating) continue;
    of_filler.coating = phases.index_of(phase_of(stage, filler.coating->material));
    of_filler.coating_thickness = filler.coating->thickness;
  }
  return of_fillers;
}

std::vector<PhaseIndex> phases_of_labels(const Stage& stage) {
  const auto phases = phases_of(stage);
  std::vector<PhaseIndex> of_labels = {phases.index_of(name_of_matrix_phase)};
  for (const auto& filler : stage.fillers) of_labels.push_back(phases.index_of(phase_of(stage, filler.material)));
  return of_labels;
}

Labelling<2> labelling_in_plane(const Stage& stage, const StageMicrostructure& packed) {
  if (packed.shaped) return labelling_of_particles<2, ParticleLocator>(stage, *packed.shaped);
  return labelling_of_grains(stage, packed.grains.value().sites, packed.grains->film);
}

Labelling<3> labelling_in_space(const Stage& stage, const StageMicrostructure& packed) {
  if (const auto* stack = stage.stack()) return labelling_of_stack(stage, *stack);
  if (packed.grains && packed.grains->sites_in_space) {
    return labelling_of_grains(stage, *packed.grains->sites_in_space, packed.grains->film);
  }
  if (packed.ellipsoids) return labelling_of_particles<3, EllipsoidLocator>(stage, *packed.ellipsoids);
  throw InputError("labels of three dimensions: expected grains, ellipsoids or an image");
}

}  // namespace breccia
