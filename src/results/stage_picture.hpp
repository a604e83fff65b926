#pragma once

#include <string>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/report/microstructure_picture.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// SVG picture of the content of the box of a stage, seen from above; in three dimensions a picture of the plane
/// through its middle with this normal.
std::string stage_picture(const Stage& stage, const StageMicrostructure& microstructure, Axis normal = Axis::z);

}  // namespace breccia
