#include "deckfile/deck_text_exchange.hpp"

#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "deckfile/deck_text_lines.hpp"
#include "deckfile/deck_text_place.hpp"
#include "deckfile/deck_text_scan.hpp"

namespace breccia::detail {

namespace {

/// A part of the text that can change places with another one of the same kind.
struct MovablePart {
  TextSpan span;
  bool is_in_line = false;  ///< an item of an array or of a table in braces
  bool has_header = false;  ///< lines that begin with a header
  std::size_t section = 0;  ///< of lines without a header: the number of steps of the table to which they belong
};

InputError scattered(DeckSteps path) {
  return InputError(
      fmt::format("{} cannot be moved: its lines do not follow one another in the text", path_text(path)));
}

MovablePart part_in_line(const DeckStatement& line, DeckSteps path) {
  const auto place = place_in_line(line, path);
  if (place.items.size() != 1 || place.value == nullptr) throw scattered(path);
  return {place.container->items[place.items.front()].span, true, false, 0};
}

MovablePart part_of_lines(const DeckSource& source, DeckSteps path) {
  const auto first = first_within(source, path);
  const auto last = last_within(source, path);
  if (!first || !last) throw scattered(path);
  for (auto i = *first; i <= *last; ++i) {
    if (!is_within(source.statements[i].path, path)) throw scattered(path);
  }
  const auto& statement = source.statements[*first];
  return {{block_begin(source, *first), block_end(source, *last)},
          false,
          statement.form != DeckStatement::Form::entry,
          statement.section.size()};
}

MovablePart movable_part(const DeckSource& source, DeckSteps path) {
  const auto* line = line_of_value(source, path);
  const bool is_in_line = line != nullptr && line->path.size() < path.size();
  return is_in_line ? part_in_line(*line, path) : part_of_lines(source, path);
}

bool can_change_places(const MovablePart& one, const MovablePart& other) {
  if (one.is_in_line != other.is_in_line || one.has_header != other.has_header) return false;
  return one.has_header || one.section == other.section;
}

}  // namespace

std::string text_with_exchange(const std::string& text, DeckSteps one, DeckSteps other) {
  const auto source = scanned(text);
  auto first = movable_part(source, one);
  auto second = movable_part(source, other);
  if (!can_change_places(first, second)) {
    throw InputError(fmt::format("{} and {} cannot change places: they are written in different ways", path_text(one),
                                 path_text(other)));
  }
  if (first.span.begin > second.span.begin) std::swap(first, second);
  auto upper = part_of(text, first.span);
  auto lower = part_of(text, second.span);
  const auto newline = newline_of(text);
  // The last line of a text may have no line break.
  if (!first.is_in_line && upper.ends_with('\n') && !lower.ends_with('\n')) {
    lower += newline;
    upper.resize(upper.size() - newline.size());
  }
  return text.substr(0, first.span.begin) + lower + part_of(text, {first.span.end, second.span.begin}) + upper +
         text.substr(second.span.end);
}

}  // namespace breccia::detail
