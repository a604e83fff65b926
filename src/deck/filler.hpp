#pragma once

#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

#include "deck/amounts.hpp"
#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `filler`, which is one table or several, and `packing` of a stage. A list of particles and a gap in material
/// points need its box and its cells, which are read before. If both keys are absent, the stage has no fillers. `walls`
/// are those of a random packing that does not name its own; `fractions` are those of the fillers with an amount.
void read_fillers(const Section& section, const std::vector<ShiftedMaterial>& materials, Walls walls,
                  const FractionsByAmounts& fractions, Stage& stage);

/// Reports particles that do not fit into the box of a stage, if its side is known.
void check_fit(const Section& section, const Stage& stage);

}  // namespace breccia
