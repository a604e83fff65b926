#pragma once

#include <string>
#include <vector>

#include "breccia/study/stage.hpp"

namespace breccia {

/// The orientations of the crystals of a stage and their isotropic means in words: "crystals at random orientations
/// (seed 3); isotropic means by Hill: K 12.5 GPa (Reuss 12.3 GPa, Voigt 12.7 GPa), G 5.4 GPa (4.8 GPa, 6 GPa)". One
/// sentence for each filler of crystals, with its material where there are several fillers; none without crystals.
[[nodiscard]] std::vector<std::string> words_on_crystals(const Stage& stage);

}  // namespace breccia
