#pragma once

#include <string>

#include "deckfile/deck_path.hpp"

namespace breccia::detail {

/// The text with another key in place of the last one of a path, in all headers and dotted keys that have it.
std::string text_with_key(const std::string& text, DeckSteps path, const std::string& key);

}  // namespace breccia::detail
