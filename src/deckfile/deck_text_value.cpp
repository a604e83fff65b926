#include "deckfile/deck_text_value.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "deckfile/deck_text_scan.hpp"

namespace breccia::detail {

namespace {

std::vector<std::string> block_of(const std::string& header, const std::vector<EntryText>& entries) {
  std::size_t width = 0;
  for (const auto& entry : entries) width = std::max(width, key_text(entry.keys).size());
  std::vector<std::string> lines{header};
  for (const auto& entry : entries) lines.push_back(text_of(entry, width));
  return lines;
}

}  // namespace

std::string text_of(const EntryText& entry, std::size_t width) {
  auto key = key_text(entry.keys);
  key.append(width - std::min(width, key.size()), ' ');
  return fmt::format("{} = {}", key, entry.value);
}

DeckValue tree_of(const std::string& value) {
  return std::move(parse_deck("value", fmt::format("value = {}", value)).entries.at(0).value);
}

bool is_in_braces(const std::string& value) {
  return value.starts_with('{');
}

std::string wrapped(DeckSteps steps, std::string value) {
  for (; !steps.empty(); steps = steps.first(steps.size() - 1)) {
    const bool is_key = std::holds_alternative<std::string>(steps.back());
    value = is_key ? fmt::format("{{ {} = {} }}", key_text(steps.last(1)), value) : fmt::format("[{}]", value);
  }
  return value;
}

std::vector<EntryText> entries_of(const std::string& table) {
  constexpr std::string_view end = " }";
  std::vector<EntryText> entries;
  for (const auto& item : scanned_value(table).items) {
    const DeckPath keys(item.keys.begin(), item.keys.end());
    const auto first = DeckPath{keys.front()};
    const auto rest = DeckSteps(keys).subspan(1);
    const auto value = part_of(table, item.value.span);
    const auto known = std::ranges::find(entries, first, &EntryText::keys);
    if (known != entries.end()) {
      known->value.insert(known->value.size() - end.size(), fmt::format(", {} = {}", key_text(rest), value));
    } else if (rest.empty()) {
      entries.push_back({first, value});
    } else {
      entries.push_back({first, fmt::format("{{ {} = {}{}", key_text(rest), value, end)});
    }
  }
  return entries;
}

std::vector<std::string> elements_of(const std::string& array) {
  std::vector<std::string> elements;
  for (const auto& item : scanned_value(array).items) elements.push_back(part_of(array, item.span));
  return elements;
}

std::vector<std::string> table_block(DeckSteps path, const std::vector<EntryText>& entries) {
  return block_of(fmt::format("[{}]", key_text(path)), entries);
}

std::vector<std::string> element_block(DeckSteps array, const std::vector<EntryText>& entries) {
  return block_of(fmt::format("[[{}]]", key_text(array)), entries);
}

}  // namespace breccia::detail
