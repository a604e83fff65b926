#pragma once

#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

#include "deck/stage_defaults.hpp"
#include "deckfile/deck.hpp"

namespace breccia {

/// Whether a table of [[stages]] gives its cells.
bool names_cells(const Section& stage);

/// Reads [[stages]]; their materials must be among the given ones. Grains that are computed with films need no cells. A
/// random packing may leave out its box and its cells: the side and the cells of its stage are then 0.
std::vector<Stage> read_stages(const Section& deck, const std::vector<ShiftedMaterial>& materials,
                               const StageDefaults& defaults);

}  // namespace breccia
