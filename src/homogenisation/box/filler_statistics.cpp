#include "breccia/homogenisation/filler_statistics.hpp"

#include <algorithm>

#include "breccia/microstructure/statistics.hpp"

namespace breccia {
namespace {

/// The particles of one filler alone.
template <int dim>
Microstructure<dim> particles_of(const Microstructure<dim>& microstructure, std::size_t filler) {
  Microstructure<dim> own = {microstructure.side, microstructure.walls, {}};
  for (std::size_t particle = 0; particle < microstructure.particles.size(); ++particle) {
    if (microstructure.filler_of(particle) == filler) own.particles.push_back(microstructure.particles[particle]);
  }
  return own;
}

/// Share of the box that the coatings of these particles fill [-].
template <int dim>
double coating_fraction(Microstructure<dim> microstructure, double thickness) {
  if (thickness == 0.0) return 0.0;
  const double bare = volume_fraction(microstructure);
  for (auto& particle : microstructure.particles) particle.diameter += 2.0 * thickness;
  return volume_fraction(microstructure) - bare;
}

}  // namespace

template <int dim>
std::vector<FillerStatistics> filler_statistics(const Stage& stage, const Microstructure<dim>& microstructure) {
  std::vector<FillerStatistics> all;
  for (std::size_t number = 0; number < stage.fillers.size(); ++number) {
    const auto own = particles_of(microstructure, number);
    auto& statistics = all.emplace_back();
    statistics.particles = own.particles.size();
    statistics.fraction = volume_fraction(own);
    statistics.coating_fraction = coating_fraction(own, stage.fillers[number].coating_thickness());
    if (own.particles.empty()) continue;
    const auto [smallest, largest] = std::ranges::minmax(own.particles, {}, &Ball<dim>::diameter);
    statistics.smallest_diameter = smallest.diameter;
    statistics.largest_diameter = largest.diameter;
  }
  return all;
}

template std::vector<FillerStatistics> filler_statistics(const Stage&, const Microstructure<2>&);
template std::vector<FillerStatistics> filler_statistics(const Stage&, const Microstructure<3>&);

}  // namespace breccia
