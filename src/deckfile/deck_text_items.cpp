#include "deckfile/deck_text_items.hpp"

#include <string_view>

#include <fmt/format.h>

#include "deckfile/deck_text_lines.hpp"

namespace breccia::detail {

namespace {

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

std::string_view between(const std::string& text, std::size_t begin, std::size_t end) {
  return std::string_view(text).substr(begin, end - begin);
}

std::string without(std::string text, const TextSpan& span) {
  return text.erase(span.begin, span.end - span.begin);
}

/// The place after an item and its comma.
std::size_t end_with_comma(const SourceItem& item) {
  return item.comma ? *item.comma + 1 : item.span.end;
}

/// Whether nothing but blanks is before a place in its line.
bool begins_line(const std::string& text, std::size_t at) {
  return is_blank(between(text, line_begin(text, at), at));
}

/// Whether nothing but blanks and a comment is behind a place in its line.
bool ends_line(const std::string& text, std::size_t at) {
  const auto rest = between(text, at, line_end(text, at));
  return is_blank(rest.substr(0, rest.find('#')));
}

/// Whether there is a comment between two items.
bool has_comment(const std::string& text, std::size_t begin, std::size_t end) {
  return between(text, begin, end).find('#') != std::string_view::npos;
}

}  // namespace

std::string with_element(const std::string& text, const SourceValue& array, const std::string& element) {
  auto result = text;
  if (array.items.empty()) return result.insert(array.span.begin + 1, element);
  const auto& last = array.items.back();
  const bool is_in_own_line =
      begins_line(text, last.span.begin) && line_begin(text, last.span.begin) > array.span.begin;
  if (!is_in_own_line) return result.insert(last.span.end, ", " + element);

  const auto end = end_with_comma(last);
  const auto indent = between(text, line_begin(text, last.span.begin), last.span.begin);
  const auto line = fmt::format("{}{}{}{}", newline_of(text), indent, element, last.comma ? "," : "");
  const auto at = ends_line(text, end) ? content_end(text, end) : end;
  result.insert(at, line);
  return last.comma ? result : result.insert(last.span.end, ",");
}

std::string with_braced_entry(const std::string& text, const SourceValue& table, const std::string& entry) {
  if (!table.items.empty()) return with_braced_entry_after(text, table.items.back(), entry);
  auto result = text;
  return result.replace(table.span.begin, table.span.end - table.span.begin, fmt::format("{{ {} }}", entry));
}

std::string with_braced_entry_after(const std::string& text, const SourceItem& item, const std::string& entry) {
  auto result = text;
  return result.insert(item.span.end, ", " + entry);
}

std::string without_item(const std::string& text, const SourceValue& container, std::size_t index) {
  const auto& items = container.items;
  const auto& item = items[index];
  const auto end = end_with_comma(item);
  const auto inner = TextSpan{container.span.begin + 1, container.span.end - 1};
  const auto line = line_begin(text, item.span.begin);
  if (begins_line(text, item.span.begin) && ends_line(text, end) && line > container.span.begin) {
    return without(text, {line, line_end(text, end)});
  }
  // With the blanks and the comma between it and its neighbour, unless there is a comment, too.
  if (index > 0 && !has_comment(text, items[index - 1].span.end, item.span.begin)) {
    return without(text, {items[index - 1].span.end, item.span.end});
  }
  if (index + 1 < items.size() && !has_comment(text, end, items[index + 1].span.begin)) {
    return without(text, {item.span.begin, items[index + 1].span.begin});
  }
  const bool is_alone =
      is_blank(between(text, inner.begin, item.span.begin)) && is_blank(between(text, end, inner.end));
  return without(text, is_alone ? inner : TextSpan{item.span.begin, end});
}

}  // namespace breccia::detail
