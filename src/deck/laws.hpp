#pragma once

#include "breccia/viscoelasticity/prony_series.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads `{ law = "2s2p1d", ... }`, a modulus by a formula with few parameters, as a Prony series (series_of). After a
/// mistake, which is reported, the series is empty.
PronySeries read_law(const Section& modulus);

}  // namespace breccia
