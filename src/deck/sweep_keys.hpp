#pragma once

#include <string>
#include <vector>

#include "breccia/io/deck.hpp"

namespace breccia {

/// A key of `[sweep]` with its values.
struct KeyValues {
  std::string path;
  Place place;
  std::vector<PlacedScalar> values;
};

/// The keys of `[sweep]` in the order of the deck; none after a report where their combinations are too many.
std::vector<KeyValues> read_keys(const Section& deck);

}  // namespace breccia
