#pragma once

#include <optional>
#include <string>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// A warning about a box so small for a distribution of sizes that one particle is more than a quarter of all filler.
std::optional<std::string> warning_of_large_particles(const Stage& stage, const StageMicrostructure& packed);

}  // namespace breccia
