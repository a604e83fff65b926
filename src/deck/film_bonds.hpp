#pragma once

#include "breccia/study/stage.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads the table `bonds` of a stage, if it has one.
void read_bonds(const Section& section, Stage& stage);

}  // namespace breccia
