#pragma once

#include <optional>

#include "breccia/study/stage.hpp"

namespace breccia {

/// The effective number of particles of the smallest box that is chosen: none of them is more than a quarter of the
/// filler then.
inline constexpr double fewest_effective = 16.0;

/// What the sizes of the fillers of a stage make of the number of its particles in a large box (theory, Eq. 43m).
struct EffectiveParticles {
  double share = 1.0;   ///< their effective number over their number [-]: 1 for particles of one size
  double volume = 0.0;  ///< of the box for each of the effective number [m^dim]
};

/// Nothing where a filler has no fraction or no distribution of sizes.
std::optional<EffectiveParticles> effective_particles_of(const Stage& stage);

}  // namespace breccia
