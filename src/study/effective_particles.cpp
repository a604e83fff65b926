#include "study/effective_particles.hpp"

#include <cmath>

#include "breccia/microstructure/ball.hpp"

#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

/// Means over the volume of the particles of a distribution.
struct VolumeMeans {
  double volume = 0.0;   ///< of a particle [m^dim]
  double inverse = 0.0;  ///< one over the volume of a particle [m^-dim]
};

template <int dim>
VolumeMeans means_of(const SizeDistribution& sizes) {
  const double smallest = sizes.smallest(), largest = sizes.largest();
  if (!(smallest < largest)) return {ball_volume<dim>(largest), 1.0 / ball_volume<dim>(largest)};
  // The sum over parts of equal ratios of the diameter, each with the middle of its ends: with parts of 1 % to 1e-4 of
  // a smooth distribution, to 1.5 % of one that rises in steps.
  constexpr double part = 0.01;
  const auto parts = static_cast<int>(std::ceil(std::log(largest / smallest) / part));
  VolumeMeans means;
  double below = 0.0;
  for (int i = 1; i <= parts; ++i) {
    const double to = smallest * std::pow(largest / smallest, static_cast<double>(i) / parts);
    const double share = (i < parts ? sizes.cumulative(to) : 1.0) - below;
    const double volume = ball_volume<dim>(to * std::pow(smallest / largest, 0.5 / parts));
    means.volume += share * volume;
    means.inverse += share / volume;
    below += share;
  }
  return means;
}

template <int dim>
std::optional<EffectiveParticles> effective_particles_in(const Stage& stage) {
  double fraction = 0.0, squares = 0.0, number = 0.0;
  for (const auto& filler : stage.fillers) {
    const auto sizes = distribution_of(filler);
    if (!sizes || !filler.fraction) return std::nullopt;
    const auto means = means_of<dim>(*sizes);
    fraction += *filler.fraction;
    squares += *filler.fraction * means.volume;
    number += *filler.fraction * means.inverse;
  }
  if (!(number > 0.0)) return std::nullopt;
  return EffectiveParticles{.share = fraction * fraction / (squares * number),
                            .volume = squares / (fraction * fraction)};
}

}  // namespace

std::optional<EffectiveParticles> effective_particles_of(const Stage& stage) {
  return stage.dimensions() == 3 ? effective_particles_in<3>(stage) : effective_particles_in<2>(stage);
}

}  // namespace breccia
