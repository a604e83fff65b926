#pragma once

namespace breccia {

/// The largest share of its compliance by which a box with free boundaries may still ring after a traction ramp of so
/// many transits of the shear wave [-], by the envelope of the response of its slowest mode (theory, Eq. 30). 1 at
/// most.
double ringing_after_ramp(double transits);

}  // namespace breccia
