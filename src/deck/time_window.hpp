#pragma once

#include <optional>
#include <string>

#include "breccia/io/deck.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// Reads two rising times [s] from a key; nothing after a mistake was reported.
std::optional<TimeWindow> read_time_window(const Section& section, const std::string& key);

}  // namespace breccia
