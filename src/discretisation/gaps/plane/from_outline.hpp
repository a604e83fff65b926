#pragma once

#include "breccia/microstructure/vector.hpp"

namespace breccia::gaps {

/// How a point lies from an outline: its distance, negative inside, and the gradient of that, the outward normal at the
/// nearest point of the outline.
struct FromOutline {
  double distance;
  Vector<2> normal;
};

}  // namespace breccia::gaps
