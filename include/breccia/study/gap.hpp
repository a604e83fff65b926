#pragma once

#include <string>

#include "breccia/study/stage.hpp"

namespace breccia {

/// The gap of a random packing, as a share of its smallest diameter, where a deck gives none.
inline constexpr double default_gap_share = 0.1;

/// The gap that a stage with a random packing asks for, and where it comes from: "20 um (3 cells of 6.67 um, from 6
/// points)".
std::string gap_in_words(const Stage& stage);

}  // namespace breccia
