#pragma once

#include <optional>
#include <string>

#include "breccia/viscoelasticity/reduction.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads two rising times [s] from a key; nothing after a mistake was reported.
std::optional<TimeWindow> read_time_window(const Section& section, const std::string& key);

/// The window of a study from `times`, or from two rising `frequencies` f as the times 1 / (2 pi f), at which the
/// relaxation determines the dynamic moduli. Nothing after a mistake was reported.
std::optional<TimeWindow> read_times_or_frequencies(const Section& section);

}  // namespace breccia
