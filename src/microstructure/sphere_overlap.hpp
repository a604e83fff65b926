#pragma once

#include "breccia/microstructure/ball.hpp"

namespace breccia {

/// Volume [m^3] that a sphere and the box between two corners [m] have in common (theory, Eq. 42a). Its only error is
/// rounding, 1e-15 of the volume of the sphere; there is none where one of the two lies inside the other or they do not
/// meet.
[[nodiscard]] double overlap_volume(const Sphere& sphere, const Vector<3>& lower, const Vector<3>& upper);

}  // namespace breccia
