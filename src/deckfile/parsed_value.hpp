#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/deckfile/deck_setting.hpp"

#include "deckfile/deck_tree.hpp"
#include "io/range.hpp"
#include "io/units.hpp"

namespace breccia::detail {

/// The result of reading one value: the value, or a description of the expected value.
template <class T>
struct ParsedValue {
  std::optional<T> value;
  std::string mistake;
};

/// "expected a table, got 3.6"
std::string expected_but_got(std::string_view expected, const DeckValue& value);

/// A quantity with its unit, in the SI unit.
ParsedValue<double> read_quantity(const DeckValue& value, Dimension dimension, const Range& range);
ParsedValue<double> read_number(const DeckValue& value, const Range& range);
/// A number, or a share in per cent.
ParsedValue<double> read_fraction(const DeckValue& value, const Range& range);
ParsedValue<std::int64_t> read_integer(const DeckValue& value, const Range& range);
ParsedValue<bool> read_boolean(const DeckValue& value);
/// A text without control characters.
ParsedValue<std::string> read_string(const DeckValue& value);
ParsedValue<LocatedScalar> read_scalar(const DeckValue& value);
/// The index of one of several words.
ParsedValue<std::size_t> read_choice(const DeckValue& value, const std::vector<std::string>& words);

}  // namespace breccia::detail
