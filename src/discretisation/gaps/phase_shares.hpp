#pragma once

#include <span>
#include <vector>

#include "breccia/discretisation/discretisation.hpp"

#include "discretisation/mixture_rule.hpp"

namespace breccia::gaps {

/// The phases of a cell in series: what they are, their shares of its volume, and their shares in series.
struct CellShares {
  Mixture mixture;
  std::vector<VolumeAndShear> shares;
};

/// A particle in a cell.
struct ParticleShare {
  ParticlePhases phases;
  double share = 0.0;  ///< its share of the volume of the cell, coating included [-]
  double core = 1.0;   ///< the part of this that is the particle, and not its coating [-]
};

/// The phases of a cell from the shares of particles, with shares of binder for the volume and for the deviators. What
/// the binder leaves is shared by the particles; they keep a trace of it, so that they have a strain.
[[nodiscard]] CellShares in_series(PhaseIndex matrix, std::span<const ParticleShare> particles,
                                   const VolumeAndShear& binder);

}  // namespace breccia::gaps
