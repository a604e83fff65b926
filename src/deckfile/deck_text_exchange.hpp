#pragma once

#include <string>

#include "deckfile/deck_path.hpp"

namespace breccia::detail {

/// The text with two values of one table or array in each other's place: two items of a line, or all lines of both with
/// the comments right above them. Throws InputError where the lines of one do not follow one another, or where one is
/// in a line and the other one in several.
std::string text_with_exchange(const std::string& text, DeckSteps one, DeckSteps other);

}  // namespace breccia::detail
