#include "deckfile/deck_text_lines.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace breccia::detail {

namespace {

using Form = DeckStatement::Form;

/// The line that begins at a place, without its line break.
std::string_view line_at(const std::string& text, std::size_t begin) {
  return std::string_view(text).substr(begin, content_end(text, begin) - begin);
}

bool is_empty_line(const std::string& text, std::size_t begin) {
  return line_at(text, begin).find_first_not_of(" \t") == std::string_view::npos;
}

/// The number of characters of a text in UTF-8.
std::size_t width_of(std::string_view text) {
  const auto begins_character = [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U; };
  return static_cast<std::size_t>(std::ranges::count_if(text, begins_character));
}

/// The end of the empty lines from the begin of a line on.
std::size_t empty_lines_end(const std::string& text, std::size_t at) {
  while (at < text.size() && is_empty_line(text, at)) at = line_end(text, at);
  return at;
}

/// The begin of the empty lines up to the begin of a line.
std::size_t empty_lines_begin(const std::string& text, std::size_t at) {
  while (at > first_line(text)) {
    const auto above = line_begin(text, at - 1);
    if (!is_empty_line(text, above)) break;
    at = above;
  }
  return at;
}

/// The column of the `=` of an entry, from 0.
std::size_t equals_column(const DeckSource& source, std::size_t statement) {
  const auto& entry = source.statements[statement];
  return width_of(part_of(source.text, {entry.lines.begin, entry.entry.equals}));
}

/// Whether an entry follows the one before it in the same block, with no empty line between them.
bool continues_group(const DeckSource& source, std::size_t statement) {
  if (statement == 0) return false;
  const auto& before = source.statements[statement - 1];
  const auto& entry = source.statements[statement];
  if (before.form != Form::entry) return false;
  for (auto at = before.lines.end; at < entry.lines.begin; at = line_end(source.text, at)) {
    if (is_empty_line(source.text, at)) return false;
  }
  return true;
}

/// The column of the `=` of all entries of the group that a statement ends; 0 if they differ.
std::size_t common_column(const DeckSource& source, std::size_t statement) {
  const auto column = equals_column(source, statement);
  while (continues_group(source, statement)) {
    if (equals_column(source, --statement) != column) return 0;
  }
  return column;
}

/// Lines that belong to a path.
struct PartOfText {
  TextSpan lines;
  bool is_block = false;  ///< whether they begin with a header
};

/// The lines of all statements within a path: of each entry alone, but blocks that follow one another as one.
std::vector<PartOfText> parts_within(const DeckSource& source, DeckSteps path) {
  const auto& statements = source.statements;
  std::vector<PartOfText> parts;
  for (std::size_t i = 0; i < statements.size(); ++i) {
    if (!is_within(statements[i].path, path)) continue;
    if (!is_within(statements[i].section, path)) {
      parts.push_back({statements[i].lines, false});
      continue;
    }
    const auto begin = statements[i].lines.begin;
    while (i + 1 < statements.size() && is_within(statements[i + 1].section, path)) ++i;
    parts.push_back({{begin, block_end(source, i)}, true});
  }
  return parts;
}

/// The lines, for a block with the empty ones below it, as far as there are such above it, too.
TextSpan with_empty_lines(const std::string& text, const PartOfText& part) {
  if (!part.is_block) return part.lines;
  const auto above = empty_lines_begin(text, part.lines.begin);
  const auto below = empty_lines_end(text, part.lines.end);
  if (below == text.size()) return {above, below};
  const bool is_apart = above < part.lines.begin || above == first_line(text);
  return {part.lines.begin, is_apart ? below : part.lines.end};
}

void erase(std::string& text, const TextSpan& span) {
  text.erase(span.begin, span.end - span.begin);
}

}  // namespace

std::string newline_of(const std::string& text) {
  return text.find("\r\n") != std::string::npos ? "\r\n" : "\n";
}

std::size_t line_begin(const std::string& text, std::size_t at) {
  const auto before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  return before == std::string::npos ? first_line(text) : before + 1;
}

std::size_t line_end(const std::string& text, std::size_t at) {
  const auto end = text.find('\n', at);
  return end == std::string::npos ? text.size() : end + 1;
}

std::size_t content_end(const std::string& text, std::size_t at) {
  auto end = line_end(text, at);
  while (end > at && std::string_view(" \t\r\n").find(text[end - 1]) != std::string_view::npos) --end;
  return end;
}

std::string with_lines(const std::string& text, std::size_t at, const std::vector<std::string>& lines) {
  const auto newline = newline_of(text);
  std::string added;
  for (const auto& line : lines) added += line + newline;
  const bool breaks_last_line = at > first_line(text) && text[at - 1] != '\n';
  if (breaks_last_line) added = newline + added.substr(0, added.size() - newline.size());
  auto result = text;
  return result.insert(at, added);
}

std::string with_block(const std::string& text, std::size_t at, const std::vector<std::string>& lines) {
  auto block = lines;
  if (at > first_line(text) && !is_empty_line(text, line_begin(text, at - 1))) block.insert(block.begin(), "");
  if (at < text.size() && !is_empty_line(text, at)) block.emplace_back();
  return with_lines(text, at, block);
}

std::string with_entry_after(const DeckSource& source, std::size_t statement, const EntryText& entry) {
  const auto& above = source.statements[statement];
  const auto indent = part_of(source.text, {above.lines.begin, above.entry.span.begin});
  const auto column = common_column(source, statement);
  const auto width = column > indent.size() ? column - indent.size() - 1 : 0;
  return with_lines(source.text, above.lines.end, {indent + text_of(entry, width)});
}

std::size_t block_begin(const DeckSource& source, std::size_t header) {
  auto at = source.statements[header].lines.begin;
  const auto above = header == 0 ? first_line(source.text) : source.statements[header - 1].lines.end;
  while (at > above && !is_empty_line(source.text, line_begin(source.text, at - 1))) {
    at = line_begin(source.text, at - 1);
  }
  return at;
}

std::size_t block_end(const DeckSource& source, std::size_t last_statement) {
  const auto end = source.statements[last_statement].lines.end;
  const bool is_last = last_statement + 1 == source.statements.size();
  const auto next = is_last ? source.text.size() : source.statements[last_statement + 1].lines.begin;
  auto at = end;
  while (at < next && !is_empty_line(source.text, at)) at = line_end(source.text, at);
  return at == next && !is_last ? end : at;
}

std::string without_statements(const DeckSource& source, DeckSteps path) {
  const auto parts = parts_within(source, path);
  auto text = source.text;
  for (auto i = parts.size(); i-- > 0;) erase(text, with_empty_lines(source.text, parts[i]));
  return text;
}

std::string with_blocks_replaced(const DeckSource& source, DeckSteps path, const std::vector<std::string>& lines) {
  const auto parts = parts_within(source, path);
  auto text = source.text;
  for (auto i = parts.size(); i-- > 1;) erase(text, with_empty_lines(source.text, parts[i]));
  const auto& first = parts.front().lines;
  erase(text, first);
  return with_lines(text, first.begin, lines);
}

}  // namespace breccia::detail
