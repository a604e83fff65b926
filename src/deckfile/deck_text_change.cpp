#include "deckfile/deck_text_change.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "deckfile/deck_text_addition.hpp"
#include "deckfile/deck_text_items.hpp"
#include "deckfile/deck_text_lines.hpp"
#include "deckfile/deck_text_place.hpp"
#include "deckfile/deck_text_value.hpp"
#include "deckfile/deck_tree_edit.hpp"
#include "io/printable.hpp"

namespace breccia::detail {

namespace {

DeckTable parsed(const std::string& text) {
  return parse_deck("deck", text);
}

bool is_table(const DeckValue& value) {
  return kind_of(value) == Kind::table;
}

/// Whether a value is an array of tables alone, at least one, as blocks can give it.
bool is_array_of_tables(const DeckValue& value) {
  const auto* array = std::get_if<DeckArray>(&value.content);
  return array != nullptr && !array->values.empty() && std::ranges::all_of(array->values, is_table);
}

/// The text with a value, unless it has the same value already.
std::string with_other_value(const std::string& text, DeckSteps path, const std::string& value) {
  const auto tree = parsed(text);
  const auto* present = value_at(tree, path);
  const bool is_there = present != nullptr && is_same(*present, tree_of(value));
  return is_there ? text : text_with_value(text, path, value);
}

/// The text with the entries of a table in braces in place of those of a table, entry by entry.
std::string with_entries(std::string text, DeckSteps path, const std::string& table) {
  std::set<DeckPath> kept;
  for (const auto& entry : entries_of(table)) {
    text = with_other_value(text, extended(path, entry.keys), entry.value);
    kept.insert(entry.keys);
  }
  const auto tree = parsed(text);
  for (const auto& entry : std::get<DeckTable>(value_at(tree, path)->content).entries) {
    if (!kept.contains({entry.key})) text = text_without(text, extended(path, DeckStep(entry.key)));
  }
  // A table without a header is gone with its last entry.
  return value_at(parsed(text), path) == nullptr ? text_with_value(text, path, table) : text;
}

/// The text with the elements of an array of tables in place of those of another one, element by element.
std::string with_elements(std::string text, DeckSteps path, const std::string& array, std::size_t present) {
  const auto elements = elements_of(array);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    text = with_other_value(text, extended(path, DeckStep(i)), elements[i]);
  }
  for (auto i = present; i-- > elements.size();) text = text_without(text, extended(path, DeckStep(i)));
  return text;
}

/// The lines of blocks for a table or an array of tables.
std::vector<std::string> blocks_of(DeckSteps path, const std::string& value) {
  if (is_in_braces(value)) return table_block(path, entries_of(value));
  std::vector<std::string> lines;
  for (const auto& element : elements_of(value)) {
    if (!lines.empty()) lines.emplace_back();
    const auto block = element_block(path, entries_of(element));
    lines.insert(lines.end(), block.begin(), block.end());
  }
  return lines;
}

}  // namespace

std::string text_with_value(const std::string& text, DeckSteps path, const std::string& value) {
  const auto root = parsed(text);
  const auto source = scanned(text);
  const auto present = present_steps(root, path);
  if (present < path.size()) return text_with_addition(source, path, present, value);

  const auto* line = line_of_value(source, path);
  const auto* place = line != nullptr ? place_in_line(*line, path).value : nullptr;
  if (place != nullptr) return std::string(text).replace(place->span.begin, place->span.end - place->span.begin, value);

  const auto& old_value = *value_at(root, path);
  const auto new_value = tree_of(value);
  if (is_table(old_value) && is_table(new_value)) return with_entries(text, path, value);
  if (is_array_of_tables(old_value) && is_array_of_tables(new_value)) {
    return with_elements(text, path, value, std::get<DeckArray>(old_value.content).values.size());
  }
  if (std::holds_alternative<std::size_t>(path.back())) {
    throw InputError(fmt::format("{} is a block: expected a table, got {}", path_text(path), printable(value)));
  }
  const bool is_in_blocks = line == nullptr && !last_dotted_entry(source, path);
  if (is_in_blocks && (is_table(new_value) || is_array_of_tables(new_value))) {
    return with_blocks_replaced(source, path, blocks_of(path, value));
  }
  return text_with_value(text_without(text, path), path, value);
}

std::string text_without(const std::string& text, DeckSteps path) {
  const auto source = scanned(text);
  const auto* line = line_of_value(source, path);
  if (line == nullptr) return without_statements(source, path);
  if (line->path.size() == path.size()) {
    return std::string(text).erase(line->lines.begin, line->lines.end - line->lines.begin);
  }
  const auto place = place_in_line(*line, path);
  const auto rest = without_item(text, *place.container, place.items.front());
  return place.items.size() > 1 ? text_without(rest, path) : rest;
}

}  // namespace breccia::detail
