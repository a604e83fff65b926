#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"

namespace breccia {

// Measure the fractions, the outlines and the gaps of particles of other shapes than discs or spheres. The size
// deviations of the fillers that are known already are kept.
void measure_content(const Stage& stage, const ParticleBox& box, StageMicrostructure& result);
void measure_content(const Stage& stage, const EllipsoidBox& box, StageMicrostructure& result);

}  // namespace breccia
