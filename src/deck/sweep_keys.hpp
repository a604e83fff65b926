#pragma once

#include <string>
#include <vector>

#include "deckfile/deck.hpp"

namespace breccia {

/// A key of `[sweep]` with its values.
struct KeyValues {
  std::string path;
  Location location;
  std::vector<LocatedScalar> values;
};

/// The keys of `[sweep]` in the order of the deck. Reports too many combinations, and returns no keys then.
std::vector<KeyValues> read_keys(const Section& deck);

}  // namespace breccia
