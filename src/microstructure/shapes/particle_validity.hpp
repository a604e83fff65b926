#pragma once

#include "breccia/microstructure/particle_box.hpp"

namespace breccia {

/// Throws InputError if the particles are invalid: an ellipse with an axis that is not positive, a centre outside the
/// box, a particle or its coating across a hard wall, two particles that overlap by more than roundoff. The message
/// lists up to twenty mistakes, counting particles from 1.
void require_valid(const ParticleBox& box);

}  // namespace breccia
