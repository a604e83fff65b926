#pragma once

#include <string>

#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// SVG picture of a microstructure: the box seen from above, y upwards, with a scale bar.
/// Discs of a periodic box are drawn with their periodic images; all discs are clipped at the sides of the box.
/// Throws InputError if the side of the box is not positive and finite.
std::string microstructure_picture(const Microstructure<2>& microstructure);

}  // namespace breccia
