#pragma once

#include "breccia/microstructure/particle_box.hpp"

namespace breccia {

/// Throws InputError if the particles cannot be where they are: an ellipse with an axis that is not positive, a centre
/// outside the box, a particle or its coating across a hard wall, two of them that overlap by more than roundoff. The
/// message lists every one of them (up to twenty), counting particles from 1.
void require_valid(const ParticleBox& box);

}  // namespace breccia
