#include "homogenisation/box/stage_labelling.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "breccia/homogenisation/stage_discretisation.hpp"

#include "microstructure/shapes/ellipsoid_locator.hpp"
#include "microstructure/shapes/particle_locator.hpp"
#include "microstructure/tessellation/grain_locator.hpp"

namespace breccia {
namespace {

/// The phases at positions: in a particle that of its filler, in a coating that of the coating.
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

template <int dim>
Labelling<dim> labelling_of(const Stage& stage, const Grains<dim>& grains) {
  const auto phases = phases_of(stage);
  const auto matrix = phases.index_of(name_of_matrix_phase);
  const auto filler = phases.index_of(phase_of(stage, stage.fillers.front().material));
  const auto locator =
      std::make_shared<const GrainLocator<dim>>(Tessellation<dim>(grains.sites), grains.statistics.film);
  return [locator, matrix, filler](const Vector<dim>& position) -> PhaseAt {
    const auto place = locator->at(position);
    return {place.is_in_grain() ? filler : matrix, std::abs(place.depth)};
  };
}

Labelling<2> labelling_of(const Stage& stage, const ParticleBox& particles) {
  return labelling_of_particles<2, ParticleLocator>(stage, particles);
}

Labelling<3> labelling_of(const Stage& stage, const EllipsoidBox& ellipsoids) {
  return labelling_of_particles<3, EllipsoidLocator>(stage, ellipsoids);
}

template <int dim>
Labelling<dim> labelling_of(const Stage& stage, const SharedImage<dim>& image) {
  return [image, of_labels = phases_of_labels(stage)](const Vector<dim>& position) -> PhaseAt {
    return {of_labels.at(image->label_at(position)), 0.0};
  };
}

template Labelling<2> labelling_of(const Stage&, const Grains<2>&);
template Labelling<3> labelling_of(const Stage&, const Grains<3>&);
template Labelling<2> labelling_of(const Stage&, const SharedImage<2>&);
template Labelling<3> labelling_of(const Stage&, const SharedImage<3>&);

}  // namespace breccia
