#pragma once

#include <optional>

#include "breccia/microstructure/size_distribution.hpp"
#include "breccia/study/filler.hpp"

namespace breccia {

/// The size distribution from which a random packing is drawn; nothing for a list of particles. Throws InputError when
/// no part of it lies between the smallest and the largest size of the filler.
std::optional<SizeDistribution> distribution_of(const Filler& filler);

/// A range of diameters [m].
struct DiameterRange {
  double smallest;
  double largest;
};

/// The range of the diameters that a filler can have; nothing if it has no sizes.
std::optional<DiameterRange> diameters_of(const Filler& filler);

}  // namespace breccia
