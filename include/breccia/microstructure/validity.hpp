#pragma once

#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// Throws InputError if the particles cannot be where they are: a diameter that is not positive, a centre outside the
/// box, a particle across a hard wall, two particles that overlap by more than roundoff. The message lists every one of
/// them (up to twenty), counting particles from 1. Instantiated for 2 and 3 dimensions.
template <int dim>
void require_valid(const Microstructure<dim>& microstructure);

}  // namespace breccia
