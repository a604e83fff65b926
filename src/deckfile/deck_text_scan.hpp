#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "deckfile/deck_path.hpp"

namespace breccia::detail {

/// A part of a text, in bytes; its end is not part of it.
struct TextSpan {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct SourceItem;

/// A value as it is written in a text.
struct SourceValue {
  enum class Form { scalar, array, table };

  Form form = Form::scalar;
  TextSpan span;
  std::vector<SourceItem> items;  ///< of an array in brackets or a table in braces
};

/// What stands between the commas of an array or of a table in braces, or an entry `key = value` in a line.
struct SourceItem {
  TextSpan span;                     ///< from the key, in an array from the value, to the end of the value
  std::vector<std::string> keys;     ///< several for a dotted key, none in an array
  std::vector<TextSpan> key_spans;   ///< the places of the keys, with their quotes
  std::size_t equals = 0;            ///< place of `=`
  std::optional<std::size_t> comma;  ///< place of the comma after the item
  SourceValue value;
};

/// What stands in a line of a deck, or in several for a value that takes several.
struct DeckStatement {
  enum class Form { entry, table_header, element_header };  ///< `key = value`, `[table]`, `[[element]]`

  Form form = Form::entry;
  TextSpan lines;    ///< whole lines, with the line break and a comment at the end
  DeckPath section;  ///< of an entry, the path of the table whose header it follows; of a header, its own path
  DeckPath path;
  std::vector<TextSpan> header_spans;  ///< of a header, the places of its keys
  SourceItem entry;
};

/// The text of a deck and its statements in their order. Lines between them are empty or comments.
struct DeckSource {
  std::string text;
  std::vector<DeckStatement> statements;
};

/// Reads the statements of a text that is TOML (parse_deck).
DeckSource scanned(const std::string& text);

/// Reads the value at the beginning of a text, which begins with a value of TOML.
SourceValue scanned_value(const std::string& text);

/// The part of a text.
inline std::string part_of(const std::string& text, const TextSpan& span) {
  return text.substr(span.begin, span.end - span.begin);
}

/// The place where the lines of a text begin: after its byte order mark, if it has one.
std::size_t first_line(const std::string& text);

}  // namespace breccia::detail
