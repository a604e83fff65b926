#pragma once

#include <string>
#include <string_view>

#include "breccia/homogenisation/box.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// What films are that belong to the share of the bonds: "debonded" or "on springs".
[[nodiscard]] std::string_view state_of(Debonding kind);

/// How films of a stage are debonded, as its deck asks for it: "10 % of the films debonded, at random (seed 3): open
/// gaps". Empty where all are bonded.
[[nodiscard]] std::string words_on_bonds(const Stage& stage);

/// How many films of a stage are debonded, and what this means: in words. Empty where all are bonded.
[[nodiscard]] std::string words_on_debonding(const Stage& stage, const GrainStatistics& grains);

}  // namespace breccia
