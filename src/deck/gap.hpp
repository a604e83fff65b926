#pragma once

#include "breccia/io/deck.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// Reads `gap` of a filler whose sizes and packing are known, in a stage whose box and cells are known.
void read_gap(const Section& section, const Stage& stage, Filler& filler);

}  // namespace breccia
