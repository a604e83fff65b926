#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "deckfile/deck_tree.hpp"

namespace breccia::detail {

/// Applies an override to the tree, or adds a mistake: `key.path=value`, or `key.path=`, which removes the key.
/// `origin` is the name of overrides in messages (ValueOrigins).
void apply_override(DeckTable& root, const std::string& origin, const std::string& override_text,
                    std::vector<Mistake>& mistakes);

/// Applies a setting to the tree and returns the paths of the values that it has set, or adds mistakes.
std::vector<std::string> apply_setting(DeckTable& root, const Setting& setting, std::vector<Mistake>& mistakes);

/// Adds `key=value`, the key taken whole, to a table of the root, or adds a mistake.
void add_entry(DeckTable& root, const std::string& table, const Location& location, std::string_view entry,
               std::vector<Mistake>& mistakes);

}  // namespace breccia::detail
