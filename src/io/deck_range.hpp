#pragma once

#include <string>
#include <string_view>

#include "breccia/io/deck.hpp"

namespace breccia::detail {

/// Whether a value is finite and within a range.
bool accepts(const Range& range, double value);

/// A range in words, for messages: "a positive length", "a number between 0 and 1".
std::string described(const Range& range, std::string_view noun);
std::string described(const Range& range, Dimension dimension);

}  // namespace breccia::detail
