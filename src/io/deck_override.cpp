#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/nearest_name.hpp"

#include "deck_tree.hpp"

namespace breccia::detail {

namespace {

/// The steps of a dotted path; a step in double quotes may hold dots. Nothing when a step is empty.
std::optional<std::vector<std::string>> split_path(std::string_view path) {
  std::vector<std::string> steps(1);
  bool quoted = false;
  for (const char letter : path) {
    if (letter == '"') {
      quoted = !quoted;
    } else if (letter == '.' && !quoted) {
      if (steps.back().empty()) return std::nullopt;
      steps.emplace_back();
    } else if (quoted || letter != ' ') {
      steps.back() += letter;
    }
  }
  if (quoted || steps.back().empty()) return std::nullopt;
  return steps;
}

void set_place(DeckTable& table, const Place& place);

void set_place(DeckValue& value, const Place& place) {
  value.place = place;
  if (auto* table = std::get_if<DeckTable>(&value.content)) set_place(*table, place);
  if (auto* array = std::get_if<DeckArray>(&value.content)) {
    for (auto& element : array->values) set_place(element, place);
  }
}

void set_place(DeckTable& table, const Place& place) {
  table.place = place;
  for (auto& entry : table.entries) {
    entry.key_place = place;
    set_place(entry.value, place);
  }
}

/// The value of an override: TOML if it is that, else text.
DeckValue parse_value(const std::string& text, const Place& place) {
  DeckValue value{place, text};
  try {
    auto table = parse_deck("value", fmt::format("value = {}", text));
    if (table.entries.size() == 1 && table.entries[0].key == "value") value = std::move(table.entries[0].value);
  } catch (const InputError&) {
    value.content = text;
  }
  set_place(value, place);
  return value;
}

/// Follows the path of an override into the tree.
class Walk {
 public:
  explicit Walk(Place place) : place_(std::move(place)) {}

  /// The value of a key of a table, made as an empty table where it is missing.
  DeckValue* enter(DeckTable& table, const std::string& key) {
    path_ = joined(path_, key);
    if (auto* value = find(table, key)) return value;
    table.entries.push_back({key, place_, {place_, DeckTable{place_, {}}}});
    return &table.entries.back().value;
  }

  /// The element of an array that a step names; null, with a mistake, when there is none.
  DeckValue* enter(DeckArray& array, const std::string& step) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < array.values.size(); ++i) names.push_back(element_name(array.values[i], i));
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == step || std::to_string(i) == step) {
        path_ = joined(path_, names[i]);
        return &array.values[i];
      }
    }
    mistake_ = fmt::format("{} has no entry \"{}\"{}", path_, step, suggestion(step, names));
    return nullptr;
  }

  DeckValue* enter(DeckValue& value, const std::string& step) {
    if (auto* table = std::get_if<DeckTable>(&value.content)) return enter(*table, step);
    if (auto* array = std::get_if<DeckArray>(&value.content)) return enter(*array, step);
    mistake_ = fmt::format("{} is {}, not a table: it has no \"{}\"", path_, shown(value), step);
    return nullptr;
  }

  [[nodiscard]] const std::string& mistake() const { return mistake_; }

 private:
  Place place_;
  std::string path_;
  std::string mistake_;
};

}  // namespace

void apply_override(DeckTable& root, const std::string& override_text, std::vector<Mistake>& mistakes) {
  const Place place{fmt::format("--set {}", override_text), 0, 0};
  const auto equals = override_text.find('=');
  const auto steps = split_path(std::string_view(override_text).substr(0, equals));
  if (equals == std::string::npos || equals + 1 == override_text.size() || !steps) {
    mistakes.push_back({place, "expected key.path=value, such as \"stages.HB-1.cells=100\""});
    return;
  }
  Walk walk(place);
  auto* value = walk.enter(root, steps->front());
  for (std::size_t i = 1; i < steps->size() && value != nullptr; ++i) value = walk.enter(*value, (*steps)[i]);
  if (value == nullptr) {
    mistakes.push_back({place, walk.mistake()});
    return;
  }
  *value = parse_value(override_text.substr(equals + 1), place);
}

}  // namespace breccia::detail
