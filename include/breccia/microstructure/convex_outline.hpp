#pragma once

#include "breccia/microstructure/vector.hpp"

namespace breccia {

/// The point of a convex outline that lies farthest along a direction (theory, Eq. 51).
struct SupportPoint {
  Vector<2> point;             ///< position relative to the centre of the outline [m]
  double radius_of_curvature;  ///< radius of curvature of the outline at the point [m]; 0 in a corner
};

}  // namespace breccia
