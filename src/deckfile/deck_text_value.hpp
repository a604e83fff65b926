#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "deckfile/deck_path.hpp"

namespace breccia::detail {

/// An entry of a table, its value as TOML.
struct EntryText {
  DeckPath keys;  ///< several for a dotted key
  std::string value;
};

/// `key = value`, the key filled up with blanks to a width.
std::string text_of(const EntryText& entry, std::size_t width = 0);

/// The value that a text of TOML gives.
DeckValue tree_of(const std::string& value);

/// Whether a value is written as a table in braces.
bool is_in_braces(const std::string& value);

/// The value within the tables and arrays of these steps: `{ a = [value] }`.
std::string wrapped(DeckSteps steps, std::string value);

/// The entries of a table in braces. Dotted keys that begin alike are one entry: `a.b = 1, a.c = 2` is
/// `a = { b = 1, c = 2 }`.
std::vector<EntryText> entries_of(const std::string& table);

/// The elements of an array in brackets.
std::vector<std::string> elements_of(const std::string& array);

/// The lines of the block `[path]` with these entries, their `=` one below the other.
std::vector<std::string> table_block(DeckSteps path, const std::vector<EntryText>& entries);

/// The lines of the block `[[array]]`, which is one element of the array.
std::vector<std::string> element_block(DeckSteps array, const std::vector<EntryText>& entries);

}  // namespace breccia::detail
