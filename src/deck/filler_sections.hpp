#pragma once

#include <vector>

#include "deckfile/deck.hpp"

namespace breccia {

/// The tables of the fillers of a stage.
[[nodiscard]] std::vector<Section> filler_sections(const Section& stage);

}  // namespace breccia
