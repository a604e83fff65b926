#pragma once

#include <optional>
#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/study/tests.hpp"

#include "deck/stage_defaults.hpp"
#include "deckfile/deck.hpp"

namespace breccia {

/// Reads tests.mixing, whose default depends on the whole study: nothing where the deck does not have it.
std::optional<Mixing> read_mixing(const Section& deck);

/// Reads the rest of [tests]; the stages have been read before.
Tests read_tests(const Section& deck, const std::vector<Stage>& stages, const StageDefaults& defaults);

}  // namespace breccia
