#pragma once

#include <string>

#include "breccia/study/stage.hpp"

namespace breccia {

/// The orientations of the crystals of a filler and their isotropic means in words: "crystals at random orientations
/// (seed 3), isotropic means K 12.5 GPa (12.3 to 12.7), G 5.4 GPa (4.8 to 6)".
[[nodiscard]] std::string words_on_crystals(const Stage& stage, const Crystal& crystal);

}  // namespace breccia
