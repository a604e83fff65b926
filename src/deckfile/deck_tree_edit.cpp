#include "deckfile/deck_tree_edit.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace breccia::detail {

namespace {

/// The value that a step leads to; it is added if it is missing.
DeckValue& made(DeckValue& value, const DeckStep& step) {
  if (const auto* key = std::get_if<std::string>(&step)) {
    if (kind_of(value) != Kind::table) value.content = DeckTable();
    auto& table = std::get<DeckTable>(value.content);
    if (find(table, *key) == nullptr) table.entries.push_back({*key, {}, {}});
    return *find(table, *key);
  }
  if (kind_of(value) != Kind::array) value.content = DeckArray();
  auto& elements = std::get<DeckArray>(value.content).values;
  const auto index = std::get<std::size_t>(step);
  if (index == elements.size()) elements.push_back({});
  return elements.at(index);
}

/// Calls an action with the value at a path, which may be empty; what is missing on the path is added.
template <class Action>
void change_at(DeckTable& root, DeckSteps path, const Action& action) {
  DeckValue deck{{}, std::move(root)};
  auto* place = &deck;
  for (const auto& step : path) place = &made(*place, step);
  action(*place);
  root = std::move(std::get<DeckTable>(deck.content));
}

void remove_step(DeckValue& value, const DeckStep& step) {
  if (const auto* key = std::get_if<std::string>(&step)) {
    std::erase_if(std::get<DeckTable>(value.content).entries,
                  [&](const DeckEntry& entry) { return entry.key == *key; });
    return;
  }
  auto& elements = std::get<DeckArray>(value.content).values;
  elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(std::get<std::size_t>(step)));
}

}  // namespace

bool is_same(const DeckTable& one, const DeckTable& other) {
  const auto is_in_other = [&](const DeckEntry& entry) {
    const auto* value = find(other, entry.key);
    return value != nullptr && is_same(entry.value, *value);
  };
  return one.entries.size() == other.entries.size() && std::ranges::all_of(one.entries, is_in_other);
}

bool is_same(const DeckValue& one, const DeckValue& other) {
  if (kind_of(one) != kind_of(other)) return false;
  if (const auto* table = std::get_if<DeckTable>(&one.content)) {
    return is_same(*table, std::get<DeckTable>(other.content));
  }
  const auto* array = std::get_if<DeckArray>(&one.content);
  if (array == nullptr) return content_of(one) == content_of(other);
  const auto& elements = std::get<DeckArray>(other.content).values;
  return std::ranges::equal(array->values, elements,
                            [](const DeckValue& mine, const DeckValue& theirs) { return is_same(mine, theirs); });
}

bool is_empty(const DeckValue& value) {
  const auto* table = std::get_if<DeckTable>(&value.content);
  const auto* array = std::get_if<DeckArray>(&value.content);
  return (table != nullptr && table->entries.empty()) || (array != nullptr && array->values.empty());
}

void assign(DeckTable& root, DeckSteps path, const DeckValue& value) {
  change_at(root, path, [&](DeckValue& place) { place = value; });
}

void erase(DeckTable& root, DeckSteps path) {
  change_at(root, path.first(path.size() - 1), [&](DeckValue& around) { remove_step(around, path.back()); });
}

void rename(DeckTable& root, DeckSteps path, const std::string& key) {
  change_at(root, path.first(path.size() - 1), [&](DeckValue& around) {
    auto& entries = std::get<DeckTable>(around.content).entries;
    std::ranges::find(entries, std::get<std::string>(path.back()), &DeckEntry::key)->key = key;
  });
}

void exchange(DeckTable& root, DeckSteps one, DeckSteps other) {
  if (std::holds_alternative<std::string>(one.back())) return;
  change_at(root, one.first(one.size() - 1), [&](DeckValue& around) {
    auto& elements = std::get<DeckArray>(around.content).values;
    std::swap(elements.at(std::get<std::size_t>(one.back())), elements.at(std::get<std::size_t>(other.back())));
  });
}

}  // namespace breccia::detail
