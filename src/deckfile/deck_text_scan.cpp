#include "deckfile/deck_text_scan.hpp"

#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace breccia::detail {

namespace {

/// The text of a string or a quoted key, without quotes and escapes.
std::string unquoted(const std::string& quoted) {
  const auto table = parse_deck("key", fmt::format("key = {}", quoted));
  return std::get<std::string>(table.entries.at(0).value.content);
}

/// The parts of a key, and where they are written.
struct DottedKey {
  std::vector<std::string> names;
  std::vector<TextSpan> spans;
};

/// Reads TOML that the parser has accepted, from a place on.
class TomlScanner {
 public:
  TomlScanner(const std::string& text, std::size_t at) : text_(text), at_(at) {}

  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] bool is_at_end() const { return at_ >= text_.size(); }
  [[nodiscard]] bool is_at(std::string_view word) const {
    return std::string_view(text_).substr(std::min(at_, text_.size())).starts_with(word);
  }
  void pass(std::string_view word) {
    if (!is_at(word)) throw std::logic_error(fmt::format("TOML is not understood: no {} at byte {}", word, at_));
    at_ += word.size();
  }
  void pass_blanks() { at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size()); }
  void pass_line() { at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1; }

  /// A key, dotted or not.
  DottedKey keys() {
    DottedKey keys;
    while (true) {
      pass_blanks();
      const auto begin = at_;
      keys.names.push_back(key());
      keys.spans.push_back({begin, at_});
      pass_blanks();
      if (!is_at(".")) return keys;
      pass(".");
    }
  }

  /// `key = value`.
  SourceItem entry() {
    SourceItem item;
    item.span.begin = at_;
    auto key = keys();
    item.keys = std::move(key.names);
    item.key_spans = std::move(key.spans);
    item.equals = at_;
    pass("=");
    pass_blanks();
    item.value = value();
    item.span.end = at_;
    return item;
  }

  SourceValue value() {
    SourceValue value;
    value.span.begin = at_;
    if (is_at("[")) {
      value.form = SourceValue::Form::array;
      value.items = elements();
    } else if (is_at("{")) {
      value.form = SourceValue::Form::table;
      value.items = entries();
    } else if (is_at("\"") || is_at("'")) {
      pass_string();
    } else {
      pass_word();
    }
    value.span.end = at_;
    return value;
  }

 private:
  std::vector<SourceItem> elements() {
    std::vector<SourceItem> items;
    pass("[");
    pass_between();
    while (!is_at("]")) {
      SourceItem item;
      item.value = value();
      item.span = item.value.span;
      pass_comma(item);
      items.push_back(std::move(item));
    }
    pass("]");
    return items;
  }

  std::vector<SourceItem> entries() {
    std::vector<SourceItem> items;
    pass("{");
    pass_between();
    while (!is_at("}")) {
      auto item = entry();
      pass_comma(item);
      items.push_back(std::move(item));
    }
    pass("}");
    return items;
  }

  /// Passes the comma after an item, if there is one, and goes on to the next item or to the bracket.
  void pass_comma(SourceItem& item) {
    pass_between();
    if (!is_at(",")) return;
    item.comma = at_;
    pass(",");
    pass_between();
  }

  /// Passes blanks, line breaks and comments.
  void pass_between() {
    while (true) {
      at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
      if (!is_at("#")) return;
      pass_line();
    }
  }

  std::string key() {
    const auto begin = at_;
    if (is_at("\"") || is_at("'")) {
      pass_string();
      return unquoted(part_of(text_, {begin, at_}));
    }
    at_ = std::min(text_.find_first_of(" \t.=]", at_), text_.size());
    return part_of(text_, {begin, at_});
  }

  /// Passes a number, a date or a boolean: all up to what follows a value. A date may have a blank in it.
  void pass_word() {
    const auto end = std::min(text_.find_first_of(",]}#\r\n", at_), text_.size());
    if (end == at_) throw std::logic_error(fmt::format("TOML is not understood: no value at byte {}", at_));
    at_ = text_.find_last_not_of(" \t", end - 1) + 1;
  }

  void pass_string() {
    const std::string quote(1, text_[at_]);
    const auto triple = quote + quote + quote;
    const auto& end = is_at(triple) ? triple : quote;
    const bool has_escapes = quote == "\"";
    pass(end);
    while (!is_at(end)) {
      if (is_at_end()) throw std::logic_error("TOML is not understood: a string without an end");
      const std::size_t length = has_escapes && is_at("\\") ? 2 : 1;
      at_ += length;
    }
    pass(end);
    // Up to two quotes before the three that end a string are part of it.
    for (int i = 0; i < 2 && end == triple && is_at(quote); ++i) pass(quote);
  }

  const std::string& text_;
  std::size_t at_;
};

/// Finds the paths of headers: `[stages.filler]` belongs to the last of the `[[stages]]` above it.
class HeaderPaths {
 public:
  DeckPath of_table(const std::vector<std::string>& keys) {
    DeckPath path;
    for (const auto& key : keys) {
      path.emplace_back(key);
      const auto count = counts_.find(path);
      if (count != counts_.end()) path.emplace_back(count->second - 1);
    }
    return path;
  }
  DeckPath of_element(const std::vector<std::string>& keys) {
    auto path = of_table({keys.begin(), keys.end() - 1});
    path.emplace_back(keys.back());
    const auto index = counts_[path]++;
    path.emplace_back(index);
    return path;
  }

 private:
  std::map<DeckPath, std::size_t> counts_;  ///< of the elements so far, by the path of their array
};

}  // namespace

DeckSource scanned(const std::string& text) {
  DeckSource source{text, {}};
  TomlScanner scanner(text, first_line(text));
  HeaderPaths headers;
  DeckPath section;
  while (!scanner.is_at_end()) {
    DeckStatement statement;
    statement.lines.begin = scanner.at();
    scanner.pass_blanks();
    const bool is_statement =
        !scanner.is_at_end() && !scanner.is_at("#") && !scanner.is_at("\r") && !scanner.is_at("\n");
    if (scanner.is_at("[[")) {
      statement.form = DeckStatement::Form::element_header;
      scanner.pass("[[");
      auto keys = scanner.keys();
      statement.path = section = headers.of_element(keys.names);
      statement.header_spans = std::move(keys.spans);
    } else if (scanner.is_at("[")) {
      statement.form = DeckStatement::Form::table_header;
      scanner.pass("[");
      auto keys = scanner.keys();
      statement.path = section = headers.of_table(keys.names);
      statement.header_spans = std::move(keys.spans);
    } else if (is_statement) {
      statement.entry = scanner.entry();
      statement.path = section;
      for (const auto& key : statement.entry.keys) statement.path.emplace_back(key);
    }
    if (!scanner.is_at_end()) scanner.pass_line();
    statement.section = section;
    statement.lines.end = scanner.at();
    if (is_statement) source.statements.push_back(std::move(statement));
  }
  return source;
}

SourceValue scanned_value(const std::string& text) {
  return TomlScanner(text, 0).value();
}

std::size_t first_line(const std::string& text) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  return text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
}

}  // namespace breccia::detail
