#include "deckfile/deck_path.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/printable.hpp"

namespace breccia::detail {

namespace {

/// The key as TOML, in quotes if it needs them.
std::string toml_key(const std::string& key) {
  const auto is_bare = [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           letter == '-' || letter == '_';
  };
  return !key.empty() && std::ranges::all_of(key, is_bare) ? key : toml_text(key);
}

/// The entry or the element that one step leads to, or nullptr.
const DeckValue* entered_by(const DeckValue& value, const DeckStep& step) {
  const auto* key = std::get_if<std::string>(&step);
  if (const auto* table = std::get_if<DeckTable>(&value.content)) return key != nullptr ? find(*table, *key) : nullptr;
  const auto* array = std::get_if<DeckArray>(&value.content);
  if (array == nullptr || key != nullptr) return nullptr;
  const auto index = std::get<std::size_t>(step);
  return index < array->values.size() ? &array->values[index] : nullptr;
}

InputError no_element(const std::string& array, std::size_t index, std::size_t next) {
  return InputError(fmt::format("{} has no element {}: the next one is {}", array, index, next));
}

/// Refuses a step that no edit could add to the value at `path`.
void refuse_impossible(DeckSteps path, const DeckValue& value, const DeckStep& step) {
  const auto* key = std::get_if<std::string>(&step);
  const auto place = path.empty() ? "the deck" : path_text(path);
  if (const auto* array = std::get_if<DeckArray>(&value.content)) {
    if (key != nullptr) throw InputError(fmt::format("{} is an array: it has no \"{}\"", place, path_text({&step, 1})));
    const auto index = std::get<std::size_t>(step);
    const auto next = array->values.size();
    if (index > next) throw no_element(place, index, next);
    return;
  }
  if (kind_of(value) != Kind::table) {
    throw InputError(fmt::format("{} is {}, no table and no array: it has no \"{}\"", place, printable(shown(value)),
                                 path_text({&step, 1})));
  }
  if (key == nullptr) {
    throw InputError(fmt::format("{} is a table: it has no element {}", place, std::get<std::size_t>(step)));
  }
}

/// Refuses an index other than 0 in an array that is missing, which begins at a step or further on.
void refuse_gaps(DeckSteps path, std::size_t begin) {
  for (auto i = begin; i < path.size(); ++i) {
    const auto* index = std::get_if<std::size_t>(&path[i]);
    if (index != nullptr && *index > 0) throw no_element(path_text(path.first(i)), *index, 0);
  }
}

}  // namespace

std::string path_text(DeckSteps path) {
  std::string text;
  for (const auto& step : path) {
    const auto* key = std::get_if<std::string>(&step);
    text = joined(text, key != nullptr ? *key : std::to_string(std::get<std::size_t>(step)));
  }
  return printable(text);
}

std::string key_text(DeckSteps path) {
  std::vector<std::string> keys;
  for (const auto& step : path) {
    if (const auto* key = std::get_if<std::string>(&step)) keys.push_back(toml_key(*key));
  }
  return fmt::format("{}", fmt::join(keys, "."));
}

DeckPath extended(DeckSteps path, DeckSteps further) {
  DeckPath all(path.begin(), path.end());
  all.insert(all.end(), further.begin(), further.end());
  return all;
}

DeckPath extended(DeckSteps path, const DeckStep& further) {
  return extended(path, DeckSteps(&further, 1));
}

bool is_within(DeckSteps path, DeckSteps top) {
  return path.size() >= top.size() && std::equal(top.begin(), top.end(), path.begin());
}

const DeckValue* value_at(const DeckTable& root, DeckSteps path) {
  const auto* key = std::get_if<std::string>(&path.front());
  const auto* value = key != nullptr ? find(root, *key) : nullptr;
  for (const auto& step : path.subspan(1)) {
    if (value != nullptr) value = entered_by(*value, step);
  }
  return value;
}

std::size_t present_steps(const DeckTable& root, DeckSteps path) {
  const DeckValue deck{root.location, root};
  const auto* value = &deck;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto* further = entered_by(*value, path[i]);
    if (further == nullptr) {
      refuse_impossible(path.first(i), *value, path[i]);
      refuse_gaps(path, i + 1);
      return i;
    }
    value = further;
  }
  return path.size();
}

}  // namespace breccia::detail
