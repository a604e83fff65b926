#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The orientations of the crystals of each filler of a stage and their isotropic means in words: "crystals of hmx at
/// random orientations (seed 3); isotropic means by Hill: K 12.5 GPa (Reuss 12.3 GPa, Voigt 12.7 GPa), G 5.4 GPa
/// (4.8 GPa, 6 GPa)".
[[nodiscard]] std::vector<std::string> words_on_crystals(const Stage& stage);

/// Warnings of the crystals of a stage: constants whose units may be wrong, a stage of aligned crystals that serves as
/// a matrix, motion out of the plane that is held, and cells that are so large that most of them take isotropic means.
[[nodiscard]] std::vector<std::string> warnings_of_crystals(const Study& study, const Stage& stage,
                                                            const StageMicrostructure& packed);

}  // namespace breccia
