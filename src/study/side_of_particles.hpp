#pragma once

#include "breccia/study/stage.hpp"

namespace breccia {

/// The side of a box [m] in which the sizes of a stage's fillers draw this number of particles, so that they fill
/// exactly the fraction that is asked for: the side of the stage itself is not used. Rounded to six digits. Sizes that
/// are drawn for a given side fill the box to within half of the smallest particle instead. With several fillers the
/// number is met to within some per cent. Throws InputError where a filler has no fraction or no distribution of
/// sizes, and as draw_diameters().
double side_of_particles(const Stage& stage, int particles);

}  // namespace breccia
