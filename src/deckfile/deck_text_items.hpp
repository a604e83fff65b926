#pragma once

#include <cstddef>
#include <string>

#include "deckfile/deck_text_scan.hpp"

namespace breccia::detail {

/// The text with one more element at the end of an array: in a line of its own if the last one is in such a line.
std::string with_element(const std::string& text, const SourceValue& array, const std::string& element);

/// The text with one more entry `key = value` at the end of a table in braces.
std::string with_braced_entry(const std::string& text, const SourceValue& table, const std::string& entry);

/// The text with one more entry after one of those of a table in braces.
std::string with_braced_entry_after(const std::string& text, const SourceItem& item, const std::string& entry);

/// The text without an item of an array or a table in braces and without a comma too many.
std::string without_item(const std::string& text, const SourceValue& container, std::size_t index);

}  // namespace breccia::detail
