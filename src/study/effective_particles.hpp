#pragma once

#include <optional>

#include "breccia/study/stage.hpp"

namespace breccia {

/// What the sizes of the fillers of a stage make of the number of its particles in a large box (theory, Eq. 43m).
struct EffectiveParticles {
  double share = 1.0;   ///< their effective number over their number [-]: 1 for particles of one size
  double volume = 0.0;  ///< of the box for each of the effective number [m^dim]
};

/// Nothing where a filler has no fraction or no distribution of sizes.
std::optional<EffectiveParticles> effective_particles_of(const Stage& stage);

}  // namespace breccia
