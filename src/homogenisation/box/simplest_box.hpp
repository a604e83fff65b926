#pragma once

#include "breccia/homogenisation/box.hpp"

namespace breccia {

// A box of particles of any shape, in the simplest form: particles that are all discs or spheres become a
// Microstructure, for which solvers and pictures have simpler rules.
Box<2> simplest_box(ParticleBox box);
Box<3> simplest_box(EllipsoidBox box);

}  // namespace breccia
