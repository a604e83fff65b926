#pragma once

#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// Throws InputError if the particles are invalid: a diameter that is not positive, a centre outside the box, a
/// particle across a hard wall, two particles that overlap by more than roundoff. The message lists up to twenty
/// mistakes, counting particles from 1. Instantiated for 2 and 3 dimensions.
template <int dim>
void require_valid(const Microstructure<dim>& microstructure);

}  // namespace breccia
