#pragma once

#include <optional>

#include "breccia/deckfile/deck.hpp"
#include "breccia/study/filler.hpp"

namespace breccia {

/// Reads `sizes` of a filler.
std::optional<Sizes> read_sizes(const Section& filler);

}  // namespace breccia
