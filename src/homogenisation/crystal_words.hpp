#pragma once

#include <string>

#include "breccia/study/stage.hpp"

namespace breccia {

/// The orientations of the crystals of a filler and their isotropic means in words: "crystals at random orientations
/// (seed 3); isotropic means by Hill: K 12.5 GPa (Reuss 12.3 GPa, Voigt 12.7 GPa), G 5.4 GPa (4.8 GPa, 6 GPa)".
[[nodiscard]] std::string words_on_crystals(const Stage& stage, const Crystal& crystal);

}  // namespace breccia
