#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Warnings of the crystals of a stage: constants whose units may be wrong, a stage of aligned crystals that serves as
/// a matrix, motion out of the plane that is held, and cells that are so large that most of them take isotropic means.
[[nodiscard]] std::vector<std::string> warnings_of_crystals(const Study& study, const Stage& stage,
                                                            const StageMicrostructure& packed);

}  // namespace breccia
