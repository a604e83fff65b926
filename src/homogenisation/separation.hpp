#pragma once

#include <optional>
#include <string>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// A warning if the particles of a stage are not far larger than those of the stage that is its matrix, or if its gaps
/// are narrower than those particles, which then could not be between them.
std::optional<std::string> warning_of_separation(const Study& study, const Stage& stage,
                                                 const StageMicrostructure& packed);

}  // namespace breccia
