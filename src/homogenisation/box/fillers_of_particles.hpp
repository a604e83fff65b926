#pragma once

#include <cstddef>
#include <vector>

#include "breccia/homogenisation/stage_microstructure.hpp"

namespace breccia {

/// The number of the filler of each particle or grain of a box, from 0; none for an image, whose pixels do not
/// distinguish particles.
[[nodiscard]] std::vector<std::size_t> fillers_of_particles(const StageMicrostructure& microstructure);

}  // namespace breccia
