#pragma once

#include <string>

#include "breccia/study/stage.hpp"

namespace breccia {

/// The gap of a random packing as a share of its smallest diameter [-], if the deck does not give a gap.
inline constexpr double default_gap_share = 0.1;

/// The gap of a filler of a stage with a random packing in words, with the form in which the deck gives it: "20 um (3
/// cells of 6.67 um, from 6 points)".
std::string gap_in_words(const Stage& stage, const Filler& filler);

/// The gaps of all fillers of a stage with a random packing in words; a gap that several fillers have occurs once.
std::string gaps_in_words(const Stage& stage);

}  // namespace breccia
