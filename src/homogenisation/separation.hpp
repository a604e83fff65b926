#pragma once

#include <optional>
#include <string>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Warns of particles that are not far larger than those of the stage that is their matrix, and of gaps narrower than
/// those: there the matrix stands for a mixture that has no room.
std::optional<std::string> warning_of_separation(const Study& study, const Stage& stage,
                                                 const StageMicrostructure& packed);

}  // namespace breccia
