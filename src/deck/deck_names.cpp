#include "deck/deck_names.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "breccia/deckfile/deck_setting.hpp"
#include "breccia/error.hpp"
#include "breccia/viscoelasticity/material.hpp"

#include "deckfile/deck_text_edit.hpp"
#include "deckfile/deck_tree.hpp"

namespace breccia {
namespace {

using detail::DeckArray;
using detail::DeckTable;
using detail::DeckValue;

constexpr std::string_view materials_key = "materials", stages_key = "stages", sweep_key = "sweep";

const std::string* text_in(const DeckValue& value) {
  return std::get_if<std::string>(&value.content);
}

const DeckTable* table_in(const DeckValue* value) {
  return value == nullptr ? nullptr : std::get_if<DeckTable>(&value->content);
}

const DeckArray* array_in(const DeckValue* value) {
  return value == nullptr ? nullptr : std::get_if<DeckArray>(&value->content);
}

/// The elements of an array of the deck, such as its stages; none where it has no such array.
std::vector<DeckValue> elements_of(const DeckTable& root, std::string_view key) {
  const auto* array = array_in(find(root, key));
  return array == nullptr ? std::vector<DeckValue>() : array->values;
}

/// The name of a stage; empty if it has none.
std::string name_of(const DeckValue& stage) {
  const auto* table = table_in(&stage);
  const auto* name = table == nullptr ? nullptr : find(*table, "name");
  return name == nullptr || text_in(*name) == nullptr ? "" : *text_in(*name);
}

bool has_material(const DeckTable& root, std::string_view name) {
  const auto* materials = table_in(find(root, materials_key));
  return materials != nullptr && find(*materials, name) != nullptr;
}

bool has_stage(const DeckTable& root, std::string_view name) {
  const auto stages = elements_of(root, stages_key);
  return std::ranges::any_of(stages, [&](const DeckValue& stage) { return name_of(stage) == name; });
}

/// A name that changes.
struct Renaming {
  std::string table;  ///< "materials" or "stages"
  std::string from;
  std::string to;
};

/// A key of the sweep with another name in it.
struct ChangedKey {
  DeckPath path;
  std::string key;
};

/// A key of a sweep, as it stands in the table `[sweep]` or in one within it.
struct SweptEntry {
  DeckPath at;                     ///< place of the key in the deck
  std::vector<std::string> steps;  ///< the path that it sweeps
  std::size_t outer;               ///< number of these steps that are the tables around it
  const DeckValue* value;
};

/// Calls an action for each key of a sweep. The keys of `[sweep]` are paths, those of the tables in it are steps.
template <class Action>
void for_swept(const DeckTable& table, const DeckPath& path, const std::vector<std::string>& outer,
               const Action& action) {
  for (const auto& entry : table.entries) {
    auto steps = outer;
    const auto own = outer.empty() ? split_path(entry.key).value_or(std::vector<std::string>())
                                   : std::vector<std::string>{entry.key};
    if (own.empty()) continue;
    steps.insert(steps.end(), own.begin(), own.end());
    const auto at = detail::extended(path, DeckStep(entry.key));
    action(SweptEntry{at, steps, outer.size(), &entry.value});
    if (const auto* inner = table_in(&entry.value)) for_swept(*inner, at, steps, action);
  }
}

/// Collects the places at which a deck refers to a name.
class References {
 public:
  References(const DeckTable& root, const Renaming& renaming) : renaming_(renaming) {
    const bool is_of_material = renaming.table == materials_key;
    // A matrix and a label of this name mean the material where there is one.
    names_matrix_ = is_of_material || !has_material(root, renaming.from);
    const auto stages = elements_of(root, stages_key);
    for (std::size_t i = 0; i < stages.size(); ++i) add_stage({DeckStep(std::string(stages_key)), i}, stages[i]);
    const auto measurements = elements_of(root, "measurements");
    for (std::size_t i = 0; i < measurements.size() && !is_of_material; ++i) {
      add_entry({DeckStep("measurements"), i}, measurements[i], "stage");
    }
    if (const auto* sweep = table_in(find(root, sweep_key))) add_sweep(*sweep);
    const DeckPath varied = {DeckStep("tests"), DeckStep("quasistatic"), DeckStep("vary"), DeckStep(renaming.from)};
    if (is_of_material && detail::value_at(root, varied) != nullptr) keys_.push_back(ChangedKey{varied, renaming.to});
  }

  /// The paths of the texts that are the name.
  [[nodiscard]] const std::vector<DeckPath>& values() const { return values_; }
  /// The keys that are the name, or have it as a step of a path.
  [[nodiscard]] const std::vector<ChangedKey>& keys() const { return keys_; }

 private:
  void add_stage(const DeckPath& path, const DeckValue& stage) {
    if (names_matrix_) add_entry(path, stage, "matrix");
    const auto* table = table_in(&stage);
    if (table == nullptr) return;
    if (renaming_.table == materials_key)
      add_tables(path, *table, "filler", [&](const auto& at, const auto& filler) {
        add_entry(at, filler, "material");
        const auto* coating = table_in(&filler) == nullptr ? nullptr : find(*table_in(&filler), "coating");
        if (coating != nullptr) add_entry(extended(at, "coating"), *coating, "material");
      });
    const auto* packing = table_in(find(*table, "packing"));
    if (packing == nullptr || !names_matrix_) return;
    add_tables(extended(path, "packing"), *packing, "labels", [&](const auto& at, const auto& label) {
      for (const auto* key : {"material", "dark", "bright"}) add_entry(at, label, key);
    });
  }

  /// Calls an action with the path and the value of a table, or of each of several.
  template <class Action>
  static void add_tables(const DeckPath& path, const DeckTable& around, const char* key, const Action& action) {
    const auto* value = find(around, key);
    if (value == nullptr) return;
    const auto at = extended(path, key);
    const auto* array = array_in(value);
    if (array == nullptr) return action(at, *value);
    for (std::size_t i = 0; i < array->values.size(); ++i) action(detail::extended(at, DeckStep(i)), array->values[i]);
  }

  /// Adds an entry of a table if it is the name, or those of several values, `{ any = [...] }`, that are.
  void add_entry(const DeckPath& path, const DeckValue& around, const char* key) {
    const auto* table = table_in(&around);
    const auto* value = table == nullptr ? nullptr : find(*table, key);
    if (value == nullptr) return;
    const auto at = extended(path, key);
    if (text_in(*value) != nullptr && *text_in(*value) == renaming_.from) values_.push_back(at);
    if (const auto* several = table_in(value)) add_elements(extended(at, "any"), find(*several, "any"));
  }

  void add_elements(const DeckPath& path, const DeckValue* value) {
    const auto* array = array_in(value);
    for (std::size_t i = 0; array != nullptr && i < array->values.size(); ++i) {
      const auto* text = text_in(array->values[i]);
      if (text != nullptr && *text == renaming_.from) values_.push_back(detail::extended(path, DeckStep(i)));
    }
  }

  void add_sweep(const DeckTable& sweep) {
    for_swept(sweep, {DeckStep(std::string(sweep_key))}, {}, [this](const SweptEntry& entry) {
      if (means_name(entry.steps)) add_elements(entry.at, entry.value);
      const auto step = step_with_name(entry.steps);
      if (!step || *step < entry.outer || entry.steps[*step] != renaming_.from) return;
      auto steps = entry.steps;
      steps[*step] = renaming_.to;
      std::string key;
      for (std::size_t i = entry.outer; i < steps.size(); ++i) key = detail::joined(key, steps[i]);
      keys_.push_back(ChangedKey{entry.at, entry.outer == 0 ? key : renaming_.to});
    });
  }

  /// Whether the values at a path are names of this kind.
  [[nodiscard]] bool means_name(const std::vector<std::string>& steps) const {
    const auto& key = steps.back();
    if (key == "matrix" || key == "dark" || key == "bright") return names_matrix_;
    if (key == "material" && std::ranges::find(steps, "labels") != steps.end()) return names_matrix_;
    return key == (renaming_.table == materials_key ? "material" : "stage");
  }

  /// The step of a path that is the name of a material or a stage, if there is one.
  [[nodiscard]] std::optional<std::size_t> step_with_name(const std::vector<std::string>& steps) const {
    if (steps.size() > 1 && steps.front() == renaming_.table) return 1;
    const std::array<std::string_view, 3> varied = {"tests", "quasistatic", "vary"};
    const bool is_varied = steps.size() > varied.size() && std::equal(varied.begin(), varied.end(), steps.begin());
    return is_varied && renaming_.table == materials_key ? std::optional(varied.size()) : std::nullopt;
  }

  static DeckPath extended(const DeckPath& path, const char* key) {
    return detail::extended(path, DeckStep(std::string(key)));
  }

  Renaming renaming_;
  bool names_matrix_ = false;
  std::vector<DeckPath> values_;
  std::vector<ChangedKey> keys_;
};

/// The table in which a path leads to a material or a stage.
std::string table_of(const DeckTable& root, std::span<const DeckStep> path) {
  const bool is_there = path.size() == 2 && detail::present_steps(root, path) == 2;
  for (const auto table : {materials_key, stages_key}) {
    if (is_there && path.front() == DeckStep(std::string(table))) return std::string(table);
  }
  throw InputError(fmt::format("{} is no material and no stage", detail::path_text(path)));
}

/// The present name of the material or the stage at a path, and the one that it is to have.
Renaming renaming_at(const DeckTable& root, std::span<const DeckStep> path, const std::string& name) {
  const auto table = table_of(root, path);
  if (table == stages_key) return {table, name_of(*detail::value_at(root, path)), name};
  const auto* material = std::get_if<std::string>(&path.back());
  if (material == nullptr) throw InputError(fmt::format("{} is no material", detail::path_text(path)));
  return {table, *material, name};
}

void refuse_used_name(const DeckTable& root, const Renaming& renaming) {
  if (renaming.to.empty()) throw InputError("a name is missing");
  if (renaming.to == name_of_void) throw InputError("\"void\" is the name of what has no material");
  for (const auto& [has_it, kind] :
       {std::pair(has_material(root, renaming.to), "material"), std::pair(has_stage(root, renaming.to), "stage")}) {
    if (has_it) throw InputError(fmt::format("there is a {} {} already", kind, renaming.to));
  }
}

bool counts_stages(const DeckTable& sweep) {
  bool counts = false;
  for_swept(sweep, {DeckStep(std::string(sweep_key))}, {}, [&counts](const SweptEntry& entry) {
    const auto& steps = entry.steps;
    const auto is_digit = [](char letter) { return letter >= '0' && letter <= '9'; };
    counts = counts || (steps.size() > 1 && steps[0] == stages_key && std::ranges::all_of(steps[1], is_digit));
  });
  return counts;
}

/// Whether a path leads to the last stage of a deck.
bool is_last_stage(const DeckTable& root, std::span<const DeckStep> path) {
  const auto* stages = array_in(find(root, stages_key));
  const auto* index = std::get_if<std::size_t>(&path.back());
  return stages != nullptr && index != nullptr && *index + 1 == stages->values.size();
}

/// Whether a measurement names no stage, which is then one of the last stage.
bool has_measurement_of_last(const DeckTable& root) {
  const auto* measurements = array_in(find(root, "measurements"));
  return measurements != nullptr && std::ranges::any_of(measurements->values, [](const DeckValue& value) {
           const auto* table = table_in(&value);
           return table != nullptr && find(*table, "stage") == nullptr;
         });
}

}  // namespace

std::string deck_with_name(const std::string& text, std::span<const DeckStep> path, const std::string& name) {
  const auto root = detail::parse_deck("deck", text);
  const auto renaming = renaming_at(root, path, name);
  if (renaming.from == name) return text;
  refuse_used_name(root, renaming);
  auto edited = text;
  if (!renaming.from.empty()) {
    const References references(root, renaming);
    for (const auto& at : references.values()) edited = deck_with_value(edited, at, toml_text(name));
    for (const auto& [at, key] : references.keys()) edited = deck_with_key(edited, at, key);
  }
  if (renaming.table == materials_key) return deck_with_key(edited, path, name);
  return deck_with_value(edited, detail::extended(path, DeckStep("name")), toml_text(name));
}

std::string deck_with_order(const std::string& text, std::span<const DeckStep> one, std::span<const DeckStep> other) {
  const auto root = detail::parse_deck("deck", text);
  const auto* sweep = table_in(find(root, sweep_key));
  const bool are_stages = table_of(root, one) == stages_key;
  if (are_stages && has_measurement_of_last(root) && (is_last_stage(root, one) || is_last_stage(root, other))) {
    throw InputError(
        "a measurement without a stage is one of the last stage: name its stage before stages change places");
  }
  if (are_stages && sweep != nullptr && counts_stages(*sweep)) {
    throw InputError("the sweep of the deck counts the stages: name them there before they change places");
  }
  return deck_with_exchange(text, one, other);
}

}  // namespace breccia
