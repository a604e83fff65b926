#include "deckfile/deck_differences.hpp"

#include <algorithm>
#include <utility>

namespace breccia {

std::vector<DeckDifference> deck_differences(const std::vector<Deck>& decks) {
  std::vector<DeckDifference> all;
  for (std::size_t i = 0; i < decks.size(); ++i) {
    for (auto& [path, text] : decks[i].values()) {
      auto found = std::ranges::find(all, path, &DeckDifference::path);
      if (found == all.end()) found = all.insert(all.end(), {path, std::vector<std::string>(decks.size())});
      found->texts[i] = std::move(text);
    }
  }
  std::erase_if(all, [](const DeckDifference& one) {
    return std::ranges::all_of(one.texts, [&](const std::string& text) { return text == one.texts.front(); });
  });
  return all;
}

}  // namespace breccia
