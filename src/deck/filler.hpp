#pragma once

#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `filler`, which is one table or several, and `packing` of a stage whose box and cells have been read. If both
/// keys are absent, the stage has no fillers.
void read_fillers(const Section& section, const std::vector<ShiftedMaterial>& materials, Stage& stage);

}  // namespace breccia
