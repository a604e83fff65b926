#pragma once

#include <random>
#include <string>
#include <vector>

namespace breccia::test {

/// A kind of mistake in a deck.
struct DeckMutation {
  const char* name;
  /// Returns the deck with one such mistake, or unchanged where the mistake is not possible.
  std::string (*apply)(std::string deck, std::mt19937_64& random);
};

/// All kinds of mistakes.
const std::vector<DeckMutation>& deck_mutations();

}  // namespace breccia::test
