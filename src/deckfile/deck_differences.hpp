#pragma once

#include <string>
#include <utility>
#include <vector>

#include "deckfile/deck.hpp"

namespace breccia {

/// A value in which decks differ.
struct DeckDifference {
  std::string path;                ///< as in `--set`: `stages.composite.cells`
  std::vector<std::string> texts;  ///< the text of the value in each deck; empty where a deck does not have it
};

/// The names of the data files of a deck with the hashes of their contents.
using FilesOfDeck = std::vector<std::pair<std::string, std::string>>;

/// The values in which decks differ, overrides included, in the order of the decks.
std::vector<DeckDifference> deck_differences(const std::vector<Deck>& decks);

/// The data files in which decks differ, as "file binder.csv", with the beginnings of their hashes.
std::vector<DeckDifference> file_differences(const std::vector<FilesOfDeck>& files);

}  // namespace breccia
