#pragma once

#include <string>
#include <vector>

#include "breccia/microstructure/particle_box.hpp"
#include "breccia/report/microstructure_picture.hpp"

namespace breccia {

/// SVG picture of a box of ellipses and polygons, as microstructure_picture() draws discs. Throws InputError if the
/// side of the box is not positive and finite, or a particle belongs to none of the fillers.
std::string particle_picture(const ParticleBox& box, const std::vector<DrawnFiller>& fillers = {{}});

}  // namespace breccia
