#include "shaped_measures.hpp"

#include <algorithm>
#include <cstddef>

namespace breccia {
namespace {

/// The particles of one filler alone.
ParticleBox particles_of(const ParticleBox& box, std::size_t filler) {
  ParticleBox own = {box.side, box.walls};
  for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
    if (box.filler_of(particle) != filler) continue;
    own.particles.push_back(box.particles[particle]);
    own.coatings.push_back(box.coating_of(particle));
  }
  return own;
}

FillerStatistics statistics_of(const ParticleBox& own) {
  FillerStatistics statistics;
  statistics.particles = own.particles.size();
  statistics.fraction = volume_fraction(own);
  statistics.coating_fraction = coating_fraction(own);
  for (const auto& particle : own.particles) {
    const double diameter = equivalent_diameter(particle.shape);
    statistics.smallest_diameter = std::min(statistics.smallest_diameter.value_or(diameter), diameter);
    statistics.largest_diameter = std::max(statistics.largest_diameter.value_or(diameter), diameter);
  }
  return statistics;
}

}  // namespace

void measure_shaped(const Stage& stage, StageMicrostructure& result) {
  const auto& box = *result.shaped;
  result.fraction = volume_fraction(box);
  result.interface_per_area = specific_surface(box);
  result.gap = smallest_gap(box);
  result.wall_gap = smallest_wall_gap(box);
  result.fillers.resize(stage.fillers.size());
  for (std::size_t number = 0; number < stage.fillers.size(); ++number) {
    const auto deviation = result.fillers[number].size_deviation;
    result.fillers[number] = statistics_of(particles_of(box, number));
    result.fillers[number].size_deviation = deviation;
  }
}

}  // namespace breccia
