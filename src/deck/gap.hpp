#pragma once

#include "breccia/study/stage.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `gap` of a filler. Its sizes, and the packing, box and cells of the stage, must have been read before.
void read_gap(const Section& section, const Stage& stage, Filler& filler);

}  // namespace breccia
