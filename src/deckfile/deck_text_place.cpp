#include "deckfile/deck_text_place.hpp"

#include <algorithm>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

namespace breccia::detail {

namespace {

bool is_entry(const DeckStatement& statement) {
  return statement.form == DeckStatement::Form::entry;
}

bool is_at(DeckSteps path, DeckSteps other) {
  return path.size() == other.size() && is_within(path, other);
}

/// The last statement that meets a condition, if any does.
template <class Condition>
std::optional<std::size_t> last_statement(const DeckSource& source, const Condition& condition) {
  for (auto i = source.statements.size(); i-- > 0;) {
    if (condition(source.statements[i])) return i;
  }
  return std::nullopt;
}

/// Goes along a path by one item of an array.
ItemPlace enter_array(const SourceValue& array, DeckSteps& path) {
  const auto index = std::get<std::size_t>(path.front());
  path = path.subspan(1);
  return {&array, {index}, &array.items.at(index).value, {}};
}

/// Goes along a path by the keys of an item of a table in braces, or to its end if the keys of several lead further.
ItemPlace enter_table(const SourceValue& table, DeckSteps& path) {
  ItemPlace place{&table, {}, nullptr, path};
  for (std::size_t i = 0; i < table.items.size(); ++i) {
    const auto& item = table.items[i];
    const auto common = common_steps(item, path);
    if (common == 0) continue;
    place.items.push_back(i);
    if (common < item.keys.size()) continue;
    path = path.subspan(common);
    return {&table, {i}, &item.value, {}};
  }
  if (place.items.empty()) throw std::logic_error(fmt::format("the text of {} is not found", path_text(path)));
  return place;
}

}  // namespace

std::size_t common_steps(const SourceItem& item, DeckSteps path) {
  const auto shorter = std::min(item.keys.size(), path.size());
  for (std::size_t i = 0; i < shorter; ++i) {
    if (path[i] != DeckStep(item.keys[i])) return 0;
  }
  return shorter;
}

const DeckStatement* line_of_value(const DeckSource& source, DeckSteps path) {
  const auto holds = [&](const DeckStatement& one) { return is_entry(one) && is_within(path, one.path); };
  const auto found = std::ranges::find_if(source.statements, holds);
  return found == source.statements.end() ? nullptr : &*found;
}

ItemPlace place_in_line(const DeckStatement& line, DeckSteps path) {
  ItemPlace place{nullptr, {}, &line.entry.value, {}};
  path = path.subspan(line.path.size());
  while (!path.empty() && place.value != nullptr) {
    const auto& container = *place.value;
    const bool is_array = container.form == SourceValue::Form::array;
    place = is_array ? enter_array(container, path) : enter_table(container, path);
  }
  return place;
}

std::optional<std::size_t> first_within(const DeckSource& source, DeckSteps path) {
  const auto holds = [&](const DeckStatement& one) { return is_within(one.path, path); };
  const auto found = std::ranges::find_if(source.statements, holds);
  if (found == source.statements.end()) return std::nullopt;
  return static_cast<std::size_t>(found - source.statements.begin());
}

std::optional<std::size_t> last_within(const DeckSource& source, DeckSteps path) {
  return last_statement(source, [&](const DeckStatement& one) { return is_within(one.path, path); });
}

std::optional<std::size_t> header_of(const DeckSource& source, DeckSteps table) {
  return last_statement(source, [&](const DeckStatement& one) { return !is_entry(one) && is_at(one.path, table); });
}

std::optional<std::size_t> last_entry(const DeckSource& source, DeckSteps table) {
  return last_statement(source, [&](const DeckStatement& one) { return is_entry(one) && is_at(one.section, table); });
}

std::optional<std::size_t> last_dotted_entry(const DeckSource& source, DeckSteps table) {
  return last_statement(source, [&](const DeckStatement& one) {
    return is_entry(one) && is_within(one.path, table) && one.section.size() < table.size();
  });
}

}  // namespace breccia::detail
