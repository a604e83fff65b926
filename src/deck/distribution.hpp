#pragma once

#include <optional>
#include <string>

#include "breccia/assessment/distribution.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads what is known of an uncertain number from the table of a key: `{ value = ..., sd = ... }`,
/// `{ value = ..., factor = 2 }`, `{ from = ..., to = ... }`, the last with `scale = "logarithmic"` or without. Its
/// values have the dimension given, or are plain numbers. Only distributions within `range` are accepted: a normal one
/// has to be four standard deviations away from its ends. Returns nothing after a mistake was reported.
std::optional<Distribution> read_distribution(const Section& section, const std::string& key,
                                              std::optional<Dimension> dimension, const Range& range);

}  // namespace breccia
