#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"

namespace breccia {

/// Measures the fractions, the outlines and the gaps of the particles of other shapes than discs or spheres. What is
/// known of the size deviations of their fillers stays.
void measure_shaped(const Stage& stage, StageMicrostructure& result);

}  // namespace breccia
