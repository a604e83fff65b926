#pragma once

#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// Equal discs in columns and rows: the box [0, side]^2 is divided into columns x rows equal rectangles, and one disc
/// sits in the middle of each. Lengths in [m]. Throws InputError if a number is not positive or the discs touch.
[[nodiscard]] Microstructure regular_array(double side, int columns, int rows, double diameter,
                                           Walls walls = Walls::hard);

}  // namespace breccia
