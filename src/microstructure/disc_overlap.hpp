#pragma once

#include "breccia/microstructure/ball.hpp"

namespace breccia {

/// Area [m^2] that a disc and the rectangle between two corners [m] have in common, exact to rounding.
[[nodiscard]] double overlap_area(const Disc& disc, const Vector<2>& lower, const Vector<2>& upper);

}  // namespace breccia
