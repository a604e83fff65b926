#pragma once

#include "breccia/microstructure/vector.hpp"

namespace breccia {

/// The point of a convex outline that lies farthest along a direction (theory, Eq. 51).
struct SupportPoint {
  Vector<2> point;             ///< from the centre of the outline [m]
  double radius_of_curvature;  ///< of the outline there [m]; 0 in a corner
};

}  // namespace breccia
