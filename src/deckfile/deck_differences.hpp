#pragma once

#include <string>
#include <vector>

#include "deckfile/deck.hpp"

namespace breccia {

/// A value in which decks differ.
struct DeckDifference {
  std::string path;                ///< as in `--set`: `stages.composite.cells`
  std::vector<std::string> texts;  ///< the text of the value in each deck; empty where a deck does not have it
};

/// The values in which decks differ, overrides included, in the order of the decks.
std::vector<DeckDifference> deck_differences(const std::vector<Deck>& decks);

}  // namespace breccia
