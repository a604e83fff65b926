#include "deckfile/deck_override.hpp"

#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/nearest_name.hpp"

namespace breccia::detail {

namespace {

/// The value of an override: TOML if it can be parsed as such, otherwise text.
DeckValue parse_value(const std::string& text, const Location& location) {
  DeckValue value{location, text};
  try {
    auto table = parse_deck("value", fmt::format("value = {}", text));
    if (table.entries.size() == 1 && table.entries[0].key == "value") value = std::move(table.entries[0].value);
  } catch (const InputError&) {
    value.content = text;
  }
  set_location(value, location);
  return value;
}

/// Assigns a value to all keys that a path selects.
class Assignment {
 public:
  using Steps = std::span<const std::string>;

  /// `location` is the location of the path.
  Assignment(const DeckValue& value, const Location& location, std::vector<Mistake>& mistakes)
      : value_(value), location_(location), mistakes_(mistakes) {}

  /// Creates missing tables on the path.
  void apply(DeckTable& table, const std::string& path, Steps steps) {
    const auto& step = steps.front();
    if (step == "*") {
      for (auto& entry : table.entries) apply(entry.value, joined(path, entry.key), steps.subspan(1));
      require_some(path, table.entries.size());
      return;
    }
    auto* value = find(table, step);
    if (value == nullptr) {
      table.entries.push_back({step, location_, {location_, DeckTable{location_, {}}}});
      value = &table.entries.back().value;
    }
    apply(*value, joined(path, step), steps.subspan(1));
  }

  [[nodiscard]] const std::vector<std::string>& replaced() const { return replaced_; }

 private:
  void apply(DeckValue& value, const std::string& path, Steps steps) {
    if (steps.empty()) {
      value = value_;
      replaced_.push_back(path);
    } else if (auto* table = std::get_if<DeckTable>(&value.content)) {
      apply(*table, path, steps);
    } else if (auto* array = std::get_if<DeckArray>(&value.content)) {
      apply(*array, path, steps);
    } else {
      report(fmt::format("{} is {}, not a table: it has no \"{}\"", path, shown(value), steps.front()));
    }
  }

  void apply(DeckArray& array, const std::string& path, Steps steps) {
    const auto& step = steps.front();
    std::vector<std::string> names;
    for (std::size_t i = 0; i < array.values.size(); ++i) names.push_back(element_name(array.values[i], i));
    if (step == "*") {
      for (std::size_t i = 0; i < names.size(); ++i) apply(array.values[i], joined(path, names[i]), steps.subspan(1));
      require_some(path, names.size());
      return;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == step || std::to_string(i) == step) {
        return apply(array.values[i], joined(path, names[i]), steps.subspan(1));
      }
    }
    report(fmt::format("{} has no entry \"{}\"{}", path, step, suggestion(step, names)));
  }

  void require_some(const std::string& path, std::size_t entries) {
    if (entries == 0) report(fmt::format("{} has no entries for \"*\"", path));
  }

  void report(std::string message) { mistakes_.push_back({location_, std::move(message)}); }

  const DeckValue& value_;
  const Location& location_;
  std::vector<Mistake>& mistakes_;
  std::vector<std::string> replaced_;
};

/// Removes all keys that a path selects.
class Removal {
 public:
  using Steps = std::span<const std::string>;

  explicit Removal(Location location) : location_(std::move(location)) {}

  /// Adds a mistake if there is no such key.
  void apply(DeckTable& root, Steps steps, std::vector<Mistake>& mistakes) {
    apply(root, "", steps);
    if (removed_ == 0) mistakes.push_back(missing_.front());
  }

 private:
  void apply(DeckTable& table, const std::string& path, Steps steps) {
    std::vector<std::string> keys;
    for (const auto& entry : table.entries) keys.push_back(entry.key);
    std::size_t i = 0;
    const auto is_meant = [&](const auto&) { return is_step(steps.front(), keys[i++]); };
    if (steps.size() == 1) {
      return note(std::erase_if(table.entries, is_meant), path, steps.front(), keys);
    }
    bool has_any = false;
    for (auto& entry : table.entries) {
      if (!is_meant(entry)) continue;
      has_any = true;
      apply(entry.value, joined(path, entry.key), steps.subspan(1));
    }
    if (!has_any) note(0, path, steps.front(), keys);
  }

  void apply(DeckValue& value, const std::string& path, Steps steps) {
    if (auto* table = std::get_if<DeckTable>(&value.content)) return apply(*table, path, steps);
    if (auto* array = std::get_if<DeckArray>(&value.content)) return apply(*array, path, steps);
    note(0, path, steps.front(), {});
  }

  void apply(DeckArray& array, const std::string& path, Steps steps) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < array.values.size(); ++i) names.push_back(element_name(array.values[i], i));
    std::size_t i = 0;
    const auto is_meant = [&](const auto&) {
      const auto at = i++;
      return is_step(steps.front(), names[at]) || steps.front() == std::to_string(at);
    };
    if (steps.size() == 1) {
      return note(std::erase_if(array.values, is_meant), path, steps.front(), names);
    }
    bool has_any = false;
    for (auto& value : array.values) {
      if (!is_meant(value)) continue;
      has_any = true;
      apply(value, joined(path, names[i - 1]), steps.subspan(1));
    }
    if (!has_any) note(0, path, steps.front(), names);
  }

  [[nodiscard]] static bool is_step(const std::string& step, const std::string& name) {
    return step == "*" || step == name;
  }

  /// Adds to the number of removed keys, or notes the missing step.
  void note(std::size_t removed, const std::string& path, const std::string& step,
            const std::vector<std::string>& known) {
    removed_ += removed;
    if (removed > 0) return;
    missing_.push_back({location_, fmt::format("nothing to remove: {} has no \"{}\"{}",
                                               path.empty() ? "the deck" : path, step, suggestion(step, known))});
  }

  Location location_;
  std::size_t removed_ = 0;
  std::vector<Mistake> missing_;
};

struct KeyAndValue {
  std::string key;
  std::string value;
};

/// The two sides of `key=value`, whose value may be empty; nothing without the sign.
std::optional<KeyAndValue> split_entry(std::string_view entry) {
  const auto equals = entry.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  return KeyAndValue{std::string(entry.substr(0, equals)), std::string(entry.substr(equals + 1))};
}

}  // namespace

void apply_override(DeckTable& root, const std::string& origin, const std::string& override_text,
                    std::vector<Mistake>& mistakes) {
  const Location location{fmt::format("{} {}", origin, override_text)};
  const auto entry = split_entry(override_text);
  const auto steps = entry ? split_path(entry->key) : std::nullopt;
  if (!steps) {
    mistakes.push_back({location, "expected key.path=value, such as \"stages.HB-1.cells=100\""});
    return;
  }
  if (entry->value.empty()) return Removal(location).apply(root, *steps, mistakes);
  Assignment(parse_value(entry->value, location), location, mistakes).apply(root, "", *steps);
}

std::vector<std::string> apply_setting(DeckTable& root, const Setting& setting, std::vector<Mistake>& mistakes) {
  const auto steps = split_path(setting.path);
  if (!steps) {
    mistakes.push_back(
        {setting.path_location, fmt::format(R"(expected a key such as "tests.volumetric", got "{}")", setting.path)});
    return {};
  }
  const auto value = std::visit(
      [&](const auto& scalar) {
        return DeckValue{setting.value.location, scalar};
      },
      setting.value.value);
  Assignment assignment(value, setting.path_location, mistakes);
  assignment.apply(root, "", *steps);
  return assignment.replaced();
}

void add_entry(DeckTable& root, const std::string& table, const Location& location, std::string_view entry,
               std::vector<Mistake>& mistakes) {
  const auto parts = split_entry(entry);
  if (!parts || parts->value.empty() || !split_path(parts->key)) {
    mistakes.push_back({location, "expected key.path=[value, ...], such as \"stages.*.packing.seed=[1, 2]\""});
    return;
  }
  if (find(root, table) == nullptr) root.entries.push_back({table, location, {location, DeckTable{location, {}}}});
  auto* target = std::get_if<DeckTable>(&find(root, table)->content);
  if (target == nullptr) return;  // reported when the table is read
  if (find(*target, parts->key) != nullptr) {
    mistakes.push_back({location, fmt::format("{} has \"{}\" already", table, parts->key)});
    return;
  }
  target->entries.push_back({parts->key, location, parse_value(parts->value, location)});
}

}  // namespace breccia::detail
