#pragma once

#include <optional>

#include "breccia/microstructure/size_distribution.hpp"
#include "breccia/study/filler.hpp"

namespace breccia {

/// The distribution that a random packing is drawn from; none for a list of particles. Throws InputError when nothing
/// of it lies between the smallest and the largest size of the filler.
std::optional<SizeDistribution> distribution_of(const Filler& filler);

/// The diameters that a filler may have [m].
struct DiameterRange {
  double smallest;
  double largest;
};

/// From the smallest to the largest diameter that a filler asks for; nothing where it has no sizes.
std::optional<DiameterRange> diameters_of(const Filler& filler);

}  // namespace breccia
