#include "homogenisation/box/shaped_measures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "homogenisation/box/effective_number.hpp"

namespace breccia {
namespace {

/// The particles of one filler alone.
template <class Box>
Box particles_of(const Box& box, std::size_t filler) {
  Box own = {box.side, box.walls};
  for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
    if (box.filler_of(particle) != filler) continue;
    own.particles.push_back(box.particles[particle]);
    own.coatings.push_back(box.coating_of(particle));
  }
  return own;
}

double size_of_shape(const Particle& particle) {
  return equivalent_diameter(particle.shape);
}
double size_of_shape(const Ellipsoid& particle) {
  return equivalent_diameter(particle);
}

template <class Box>
FillerStatistics statistics_of(const Box& own) {
  FillerStatistics statistics;
  statistics.particles = own.particles.size();
  statistics.fraction = volume_fraction(own);
  statistics.coating_fraction = coating_fraction(own);
  for (const auto& particle : own.particles) {
    const double diameter = size_of_shape(particle);
    statistics.smallest_diameter = std::min(statistics.smallest_diameter.value_or(diameter), diameter);
    statistics.largest_diameter = std::max(statistics.largest_diameter.value_or(diameter), diameter);
  }
  return statistics;
}

template <class Box>
void measure_box(const Stage& stage, const Box& box, StageMicrostructure& result) {
  result.fraction = volume_fraction(box);
  result.interface_per_area = specific_surface(box);
  result.gap = smallest_gap(box);
  result.wall_gap = smallest_wall_gap(box);
  std::vector<double> volumes;
  volumes.reserve(box.particles.size());
  for (const auto& particle : box.particles) volumes.push_back(std::pow(size_of_shape(particle), stage.dimensions()));
  result.effective_particles = effective_number(volumes);
  result.fillers.resize(stage.fillers.size());
  for (std::size_t number = 0; number < stage.fillers.size(); ++number) {
    const auto deviation = result.fillers[number].size_deviation;
    result.fillers[number] = statistics_of(particles_of(box, number));
    result.fillers[number].size_deviation = deviation;
  }
}

}  // namespace

void measure_content(const Stage& stage, const ParticleBox& box, StageMicrostructure& result) {
  measure_box(stage, box, result);
}

void measure_content(const Stage& stage, const EllipsoidBox& box, StageMicrostructure& result) {
  measure_box(stage, box, result);
}

}  // namespace breccia
