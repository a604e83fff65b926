#pragma once

#include <optional>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The share of the sides of a box that lies in filler [-], of their length or, in three dimensions, of their area. A
/// boundary with prescribed displacements or tractions cuts the filler there, as a window in a larger body does.
/// Nothing for a box whose walls keep the particles inside, which is no window, and for one without fillers.
[[nodiscard]] std::optional<double> filler_on_sides(const Stage& stage, const StageMicrostructure& packed);

}  // namespace breccia
