#pragma once

#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/study/varied_material.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `vary` of [tests.quasistatic]: tables of materials with the moduli over which they vary. The stages have been
/// read before.
std::vector<VariedMaterial> read_varied_materials(const Section& quasistatic, const std::vector<Stage>& stages);

}  // namespace breccia
