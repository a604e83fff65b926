#pragma once

#include <string>

#include "deckfile/deck_path.hpp"

namespace breccia::detail {

/// The text with one value of TOML at a path (deck_with_value). Throws InputError for a path that cannot be.
std::string text_with_value(const std::string& text, DeckSteps path, const std::string& value);

/// The text without the value at a path, where there is one (deck_without).
std::string text_without(const std::string& text, DeckSteps path);

}  // namespace breccia::detail
