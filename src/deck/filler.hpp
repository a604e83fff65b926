#pragma once

#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `filler`, which is one table or several, and `packing` of a stage whose box and cells have been read. If both
/// keys are absent, the stage has no fillers. `walls` are those of a random packing that does not name its own.
void read_fillers(const Section& section, const std::vector<ShiftedMaterial>& materials, Walls walls, Stage& stage);

}  // namespace breccia
