#pragma once

#include <string>

#include "breccia/microstructure/tessellation.hpp"

namespace breccia {

/// SVG picture of the grains of a tessellation with films of this thickness [m] between them: the box seen from above,
/// y upwards, with a scale bar. Grains are clipped at the sides of the box, and in a periodic box their images are
/// drawn.
std::string grain_picture(const Tessellation<2>& tessellation, double film);

}  // namespace breccia
