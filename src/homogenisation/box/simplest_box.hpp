#pragma once

#include "breccia/homogenisation/box.hpp"

namespace breccia {

// A box of particles of any shape. Those that are all discs or spheres become such, which solvers and pictures know by
// simpler rules.
Box<2> simplest_box(ParticleBox box);
Box<3> simplest_box(EllipsoidBox box);

}  // namespace breccia
