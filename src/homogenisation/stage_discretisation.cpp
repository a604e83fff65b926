#include "breccia/homogenisation/stage_discretisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "breccia/discretisation/image_cells.hpp"
#include "breccia/discretisation/labels.hpp"
#include "breccia/discretisation/mixed_cells.hpp"
#include "breccia/error.hpp"
#include "breccia/microstructure/grain_locator.hpp"
#include "breccia/microstructure/particle_locator.hpp"

namespace breccia {

Phases phases_of(const Stage& stage) {
  return Phases(phase_names(stage));
}

std::vector<Material> materials_of(const Stage& stage, const Material& matrix) {
  std::map<std::string, Material> by_phase = {{std::string(name_of_matrix_phase), matrix}};
  for (const auto& filler : stage.fillers) {
    by_phase.emplace(phase_of(stage, filler.material), filler.material);
    if (filler.coating) by_phase.emplace(phase_of(stage, filler.coating->material), filler.coating->material);
  }
  return phases_of(stage).materials(by_phase);
}

namespace {

/// The phases of each filler of a stage.
std::vector<ParticlePhases> phases_of_fillers(const Stage& stage, const Phases& phases) {
  std::vector<ParticlePhases> of_fillers;
  for (const auto& filler : stage.fillers) {
    auto& of_filler = of_fillers.emplace_back(ParticlePhases{phases.index_of(phase_of(stage, filler.material))});
    if (!filler.coating) continue;
    of_filler.coating = phases.index_of(phase_of(stage, filler.coating->material));
    of_filler.coating_thickness = filler.coating->thickness;
  }
  return of_fillers;
}

}  // namespace

template <int dim>
Discretisation<dim> discretise(const Stage& stage, const Microstructure<dim>& microstructure, int cells,
                               Mixing mixing) {
  const auto phases = phases_of(stage);
  const auto of_fillers = phases_of_fillers(stage, phases);
  std::vector<ParticlePhases> of_particles;
  for (std::size_t particle = 0; particle < microstructure.particles.size(); ++particle) {
    const auto filler = microstructure.filler_of(particle);
    if (filler >= of_fillers.size()) {
      throw InputError(fmt::format("stage {}: a particle is of filler {}, counted from 0, but there are only {}",
                                   stage.name, filler, of_fillers.size()));
    }
    of_particles.push_back(of_fillers[filler]);
  }
  const auto matrix = phases.index_of(name_of_matrix_phase);
  const std::span<const ParticlePhases> particles(of_particles);
  return mixing == Mixing::points ? discretise(microstructure, cells, matrix, particles)
                                  : discretise_mixed(microstructure, cells, matrix, particles, phases.size());
}

template Discretisation<2> discretise(const Stage&, const Microstructure<2>&, int, Mixing);
template Discretisation<3> discretise(const Stage&, const Microstructure<3>&, int, Mixing);

namespace {

/// Places in the grains of a tessellation have the phase of the filler, those in its films that of the matrix.
Labelling<2> labelling_of(const StageGrains& grains, PhaseIndex matrix, PhaseIndex filler) {
  const auto locator = std::make_shared<const GrainLocator<2>>(Tessellation<2>(grains.sites), grains.film);
  return [locator, matrix, filler](const Vector<2>& position) -> PhaseAt {
    const auto place = locator->at(position);
    return {place.is_in_grain() ? filler : matrix, std::abs(place.depth)};
  };
}

/// Places in particles have the phases of their fillers, those in their coatings that of the coating.
Labelling<2> labelling_of(const ParticleBox& box, PhaseIndex matrix, std::vector<ParticlePhases> of_fillers) {
  const auto locator = std::make_shared<const ParticleLocator>(box);
  return [locator, matrix, of_fillers = std::move(of_fillers)](const Vector<2>& position) -> PhaseAt {
    const auto [particle, distance] = locator->at(position);
    if (!particle) return {matrix, distance};
    const auto& [phase, coating, thickness] = of_fillers.at(locator->box().filler_of(*particle));
    if (distance <= 0.0) return {phase, -distance};
    if (distance <= thickness) return {coating, std::min(distance, thickness - distance)};
    return {matrix, distance - thickness};
  };
}

Labelling<2> labelling_of(const Stage& stage, const StageMicrostructure& packed, const Phases& phases) {
  const auto matrix = phases.index_of(name_of_matrix_phase);
  if (packed.shaped) return labelling_of(*packed.shaped, matrix, phases_of_fillers(stage, phases));
  return labelling_of(*packed.grains, matrix, phases.index_of(phase_of(stage, stage.fillers.front().material)));
}

}  // namespace

namespace {

Discretisation<2> discretise_image(const Stage& stage, const LabelImage<2>& image, int cells, Mixing mixing) {
  const auto phases = phases_of(stage);
  std::vector<PhaseIndex> of_labels = {phases.index_of(name_of_matrix_phase)};
  for (const auto& filler : stage.fillers) of_labels.push_back(phases.index_of(phase_of(stage, filler.material)));
  const Grid<2> grid = {{cells, cells}, stage.side / cells};
  return mixing == Mixing::points ? discretise(grid, image, of_labels)
                                  : discretise_mixed(grid, image, of_labels, phases.size());
}

}  // namespace

StageDiscretisation discretise(const Stage& stage, const StageMicrostructure& packed, int cells, Mixing mixing) {
  if (packed.spheres) return discretise(stage, *packed.spheres, cells, mixing);
  if (const auto* image = stage.image()) return discretise_image(stage, *image, cells, mixing);
  if (!packed.grains && !packed.shaped) return discretise(stage, packed.microstructure, cells, mixing);
  const auto phases = phases_of(stage);
  const auto labelling = labelling_of(stage, packed, phases);
  const Grid<2> grid = {{cells, cells}, stage.side / cells};
  return mixing == Mixing::points ? discretise<2>(grid, labelling) : discretise_mixed(grid, labelling, phases.size());
}

std::vector<double> fractions(const StageDiscretisation& discretisation, std::size_t phases) {
  return std::visit([phases](const auto& points) { return points.fractions(phases); }, discretisation);
}

int cells_along(const StageDiscretisation& discretisation) {
  return std::visit([](const auto& points) { return points.grid().cells[0]; }, discretisation);
}

std::size_t point_count(const Stage& stage, int cells) {
  if (stage.dimensions == 3) {
    return Grid<3>{.cells = {cells, cells, cells}}.cell_count() * Discretisation<3>::points_per_cell;
  }
  return Grid<2>{.cells = {cells, cells}}.cell_count() * Discretisation<2>::points_per_cell;
}

}  // namespace breccia
