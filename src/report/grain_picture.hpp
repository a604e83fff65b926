#pragma once

#include <span>
#include <string>
#include <string_view>

#include "breccia/microstructure/cell_faces.hpp"
#include "breccia/microstructure/tessellation.hpp"

namespace breccia {

/// SVG picture of the grains of a tessellation with films of this thickness [m] between them: the box seen from above,
/// y upwards, with a scale bar. Grains are clipped at the sides of the box, and in a periodic box their images are
/// drawn. Films at debonded faces are red, and called by this state: "debonded".
std::string grain_picture(const Tessellation<2>& tessellation, double film, std::span<const CellFace<2>> debonded,
                          std::string_view state);

}  // namespace breccia
