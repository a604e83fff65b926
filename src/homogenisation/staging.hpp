#pragma once

#include <vector>

#include "breccia/microstructure/size_distribution.hpp"

namespace breccia {

/// A stage with the particles of a range of diameters.
struct SizeStage {
  double smallest = 0.0;  ///< smallest diameter [m]
  double largest = 0.0;   ///< largest diameter [m]
  double share = 0.0;     ///< share of the volume of the filler [-]
  double fraction = 0.0;  ///< volume fraction of the particles in the box of the stage [-]
};

/// Divides the particles of a composite between stages from the smallest diameters up; each stage is the matrix of the
/// next one. `fraction` is the volume fraction of the filler in the composite [-]; `bounds` are the rising diameters
/// [m] that separate the stages, one more than there are stages. With v_k the volume of the particles in stage k, their
/// fraction in its box is v_k / (1 - fraction + v_1 + ... + v_k). Throws InputError if the fraction is not between 0
/// and 1, the bounds do not rise, or a stage has no particles.
std::vector<SizeStage> divide_into_stages(const SizeDistribution& sizes, const std::vector<double>& bounds,
                                          double fraction);

}  // namespace breccia
