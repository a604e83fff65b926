#pragma once

#include <string>

#include "deckfile/deck_path.hpp"

namespace breccia::detail {

/// Whether two values are the same, wherever they are and in whatever order a table has its entries.
bool is_same(const DeckValue& one, const DeckValue& other);
bool is_same(const DeckTable& one, const DeckTable& other);

/// Whether a value is a table or an array without content.
bool is_empty(const DeckValue& value);

/// Replaces the value at a path of the tree, or adds it, with all tables and arrays that are missing.
void assign(DeckTable& root, DeckSteps path, const DeckValue& value);

/// Removes the value at a path that is there.
void erase(DeckTable& root, DeckSteps path);

/// Gives the value at a path that is there another key.
void rename(DeckTable& root, DeckSteps path, const std::string& key);

/// Exchanges two elements of an array; two entries of a table stay, since a table has no order.
void exchange(DeckTable& root, DeckSteps one, DeckSteps other);

}  // namespace breccia::detail
