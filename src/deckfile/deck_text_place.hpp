#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "deckfile/deck_text_scan.hpp"

namespace breccia::detail {

/// The place of a value within the value of a line.
struct ItemPlace {
  const SourceValue* container = nullptr;  ///< the array or table around it; null for the value of the line itself
  std::vector<std::size_t> items;          ///< those of the container that give the value
  const SourceValue* value = nullptr;      ///< null for a table that dotted keys give: `a` in `{ a.b = 1, a.c = 2 }`
  DeckSteps dotted;                        ///< the steps to such a table from its container
};

/// The number of leading steps that a path has in common with the keys of an item: all of the shorter one, or 0.
std::size_t common_steps(const SourceItem& item, DeckSteps path);

/// The entry in whose value a path ends, or nullptr if it leads to a table or an array that several lines give.
const DeckStatement* line_of_value(const DeckSource& source, DeckSteps path);

/// The place of the value at a path in such an entry.
ItemPlace place_in_line(const DeckStatement& line, DeckSteps path);

/// The first and the last statement of a table, or of an array of tables, and of all in it. None for what is not there.
std::optional<std::size_t> first_within(const DeckSource& source, DeckSteps path);
std::optional<std::size_t> last_within(const DeckSource& source, DeckSteps path);

/// The header of a table, or nothing.
std::optional<std::size_t> header_of(const DeckSource& source, DeckSteps table);

/// The last entry below the header of a table, for the root above all headers, or nothing.
std::optional<std::size_t> last_entry(const DeckSource& source, DeckSteps table);

/// The last entry of a table that has dotted keys in place of a header: `tests.accuracy = 1` gives `tests`. Or nothing.
std::optional<std::size_t> last_dotted_entry(const DeckSource& source, DeckSteps table);

}  // namespace breccia::detail
