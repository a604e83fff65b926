#pragma once

#include <optional>

#include "breccia/microstructure/size_distribution.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The size distribution from which a filler of a random packing is drawn; nothing for a list of particles. Throws
/// InputError when no part of it lies between the smallest and the largest size of the filler.
std::optional<SizeDistribution> distribution_of(const Filler& filler);

/// The ends [m] that a distribution of sizes has of its own, apart from those at which a filler cuts it.
struct SizeEnds {
  std::optional<double> smallest = {};
  std::optional<double> largest = {};
};

/// The ends of a distribution of sizes; nothing for sizes that are no distribution, which are not cut.
std::optional<SizeEnds> ends_of(const Sizes& sizes);

/// A range of diameters [m].
struct DiameterRange {
  double smallest;
  double largest;
};

/// The range of the diameters that a filler can have; nothing if it has no sizes.
std::optional<DiameterRange> diameters_of(const Filler& filler);

/// The range of the diameters that the particles of all fillers of a stage can have, without their coatings; nothing if
/// there are none.
std::optional<DiameterRange> diameters_of(const Stage& stage);

/// The requested area fraction of all fillers of a stage [-]; nothing where the stage has no fillers, or one without a
/// fraction.
std::optional<double> fraction_asked_of(const Stage& stage);

}  // namespace breccia
