#pragma once

#include <vector>

#include "breccia/microstructure/size_distribution.hpp"

namespace breccia {

/// A stage that holds a part of the sizes of a filler.
struct SizeStage {
  double smallest = 0.0;  ///< [m]
  double largest = 0.0;   ///< [m]
  double share = 0.0;     ///< of the volume of the filler [-]
  double fraction = 0.0;  ///< that its particles fill of its box [-]
};

/// Divides the particles of a composite between stages, each the matrix of the next, from the smallest up. `fraction`
/// is the filler of the whole by volume [-]; `bounds` are the rising diameters [m] at which the stages begin and end,
/// so one more than stages. With v_k the volume in stage k, its particles fill v_k / (1 - fraction + v_1 + ... + v_k)
/// of its box. Throws InputError where the fraction is not between 0 and 1, the bounds do not rise, or a stage holds
/// nothing.
std::vector<SizeStage> divide_into_stages(const SizeDistribution& sizes, const std::vector<double>& bounds,
                                          double fraction);

}  // namespace breccia
