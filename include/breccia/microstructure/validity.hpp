#pragma once

#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// Throws InputError if the discs cannot be where they are: a diameter that is not positive, a centre outside the box,
/// a disc across a hard wall, two discs that overlap by more than roundoff. The message lists every one of them (up to
/// twenty), counting discs from 1.
void require_valid(const Microstructure& microstructure);

}  // namespace breccia
