#pragma once

#include <vector>

#include "breccia/deckfile/deck.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// Reads `filler`, which is one table or several, and `packing` of a stage whose box and cells have been read. Without
/// either the stage has no fillers.
void read_fillers(const Section& section, const std::vector<Material>& materials, Stage& stage);

}  // namespace breccia
