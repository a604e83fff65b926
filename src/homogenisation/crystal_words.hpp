#pragma once

#include <string>
#include <vector>

#include "breccia/study/stage.hpp"

namespace breccia {

/// The orientations of the crystals of each filler of a stage and their isotropic means in words: "crystals of hmx at
/// random orientations (seed 3); isotropic means by Hill: K 12.5 GPa (Reuss 12.3 GPa, Voigt 12.7 GPa), G 5.4 GPa
/// (4.8 GPa, 6 GPa)".
[[nodiscard]] std::vector<std::string> words_on_crystals(const Stage& stage);

}  // namespace breccia
