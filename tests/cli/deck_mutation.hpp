#pragma once

#include <random>
#include <string>
#include <vector>

namespace breccia::test {

/// A way to get a deck wrong.
struct DeckMutation {
  const char* name;
  /// The deck with one such mistake, or as it was where it has no place for it.
  std::string (*apply)(std::string deck, std::mt19937_64& random);
};

/// All of them.
const std::vector<DeckMutation>& deck_mutations();

}  // namespace breccia::test
