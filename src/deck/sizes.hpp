#pragma once

#include <optional>

#include "breccia/study/filler.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `sizes` of a filler.
std::optional<Sizes> read_sizes(const Section& filler);

}  // namespace breccia
