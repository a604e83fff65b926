#pragma once

#include <cstddef>
#include <string>

#include "deckfile/deck_text_scan.hpp"

namespace breccia::detail {

/// The text with a value at a path of which the first `present` steps alone are there (present_steps), with all tables
/// and arrays that are missing. Throws InputError for an element of blocks `[[array]]` that is no table.
std::string text_with_addition(const DeckSource& source, DeckSteps path, std::size_t present, const std::string& value);

}  // namespace breccia::detail
