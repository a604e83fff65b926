#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace breccia::studio {

/// The values of a deck with their lines, as the page takes them: an object with a `type`, `line` and, by the type, the
/// `entries` of a table in the order of the deck, the `items` of an array or the `value` of what is neither. `inline`
/// says whether a table is written in braces. JSON has no number for infinity and no number: they are the texts "inf",
/// "-inf" and "nan". Throws InputError when the text is not TOML.
nlohmann::json deck_tree_json(const std::string& text);

}  // namespace breccia::studio
