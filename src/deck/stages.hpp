#pragma once

#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

#include "deck/stage_defaults.hpp"
#include "deckfile/deck.hpp"

namespace breccia {

/// Reads [[stages]]; their materials must be among the given ones. Grains that are computed with films need no cells.
std::vector<Stage> read_stages(const Section& deck, const std::vector<ShiftedMaterial>& materials,
                               const StageDefaults& defaults);

}  // namespace breccia
