#include "deckfile/deck_differences.hpp"

#include <algorithm>
#include <utility>

namespace breccia {
namespace {

/// The names of which decks have different texts.
std::vector<DeckDifference> differences_of(const std::vector<std::vector<std::pair<std::string, std::string>>>& decks) {
  std::vector<DeckDifference> all;
  for (std::size_t i = 0; i < decks.size(); ++i) {
    for (const auto& [path, text] : decks[i]) {
      auto found = std::ranges::find(all, path, &DeckDifference::path);
      if (found == all.end()) found = all.insert(all.end(), {path, std::vector<std::string>(decks.size())});
      found->texts[i] = text;
    }
  }
  std::erase_if(all, [](const DeckDifference& one) {
    return std::ranges::all_of(one.texts, [&](const std::string& text) { return text == one.texts.front(); });
  });
  return all;
}

}  // namespace

std::vector<DeckDifference> deck_differences(const std::vector<Deck>& decks) {
  std::vector<std::vector<std::pair<std::string, std::string>>> values;
  values.reserve(decks.size());
  for (const auto& deck : decks) values.push_back(deck.values());
  return differences_of(values);
}

std::vector<DeckDifference> file_differences(const std::vector<FilesOfDeck>& files) {
  constexpr std::size_t shown = 8;
  std::vector<FilesOfDeck> values;
  for (const auto& of_deck : files) {
    auto& own = values.emplace_back();
    for (const auto& [name, hash] : of_deck) own.emplace_back("file " + name, hash.substr(0, shown));
  }
  return differences_of(values);
}

}  // namespace breccia
