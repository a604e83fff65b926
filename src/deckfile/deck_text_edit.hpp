#pragma once

#include <span>
#include <string>

#include "deckfile/deck_path.hpp"

namespace breccia {

// Edits of the text of a deck by the path of a value. All else in the text stays as it is, comments and blanks among
// it. All functions throw InputError, with the path, when the text is not TOML, when the path leads through something
// that is no table or array, or beyond the end of an array; and std::logic_error when the edited text does not have the
// value and all other values as before.

/// The text with a value, given as TOML, at a path. A value that is there is replaced in its place; a table or an array
/// of tables in blocks (`[table]`, `[[array]]`) stays in blocks if it is replaced by such a value, and entries that are
/// the same in both stay as they are. A missing entry is added after the last one of its table; a missing table as
/// a block, with a line for each entry, unless the tables beside it are in braces. The index after the last element of
/// an array adds an element. Throws InputError when the value is not one value of TOML.
std::string deck_with_value(const std::string& text, std::span<const DeckStep> path, const std::string& value);

/// The text without the value at a path: a key with its line, an element with its comma, a table with all its blocks.
/// Comments above it stay. Throws InputError when there is no such value.
std::string deck_without(const std::string& text, std::span<const DeckStep> path);

/// The text with another key in place of the last one of a path, wherever a header or a dotted key has it. Throws
/// InputError when there is no such value, or when its table has the other key already.
std::string deck_with_key(const std::string& text, std::span<const DeckStep> path, const std::string& key);

/// The text with two entries of a table, or two elements of an array, in each other's place, with the comments right
/// above them. Throws InputError when they are not two of one table or array, or when the lines of one of them do not
/// follow one another.
std::string deck_with_exchange(const std::string& text, std::span<const DeckStep> one, std::span<const DeckStep> other);

}  // namespace breccia
