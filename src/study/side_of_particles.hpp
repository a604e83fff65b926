#pragma once

#include "breccia/study/stage.hpp"

namespace breccia {

/// The side of a box [m] in which the sizes of a stage's fillers draw this number of particles, so that they fill the
/// fraction that is asked for to 0.1 %: the side of the stage itself is not used. Rounded to six digits. Sizes that are
/// drawn for a given side fill the box to within half of the smallest particle instead. With several fillers of
/// very different sizes the number is met to within one of the largest and those that fill the box beside it. Throws
/// InputError where a filler has no fraction or no distribution of sizes, or where so few particles do not include one
/// of each filler, and as draw_diameters().
double side_of_particles(const Stage& stage, int particles);

/// The number of particles in the smallest box that holds one of each filler. Throws as side_of_particles().
int fewest_particles(const Stage& stage);

}  // namespace breccia
