#pragma once

#include "breccia/study/filler.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `from` and `to` of a filler whose sizes have been read. They cut a distribution of sizes, and are required
/// where it has no such end of its own.
void read_cuts(const Section& section, Filler& filler);

}  // namespace breccia
