#include "studio/deck_changes.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "deck/deck_names.hpp"
#include "deckfile/deck_override.hpp"
#include "deckfile/deck_text_edit.hpp"
#include "deckfile/deck_tree_edit.hpp"

namespace breccia::studio {
namespace {

DeckPath path_in(const Json& change, const char* key) {
  const auto path = change.find(key);
  DeckPath steps;
  const auto refuse = [key] { throw InputError(fmt::format("{}: expected keys and indices", key)); };
  if (path == change.end() || !path->is_array() || path->empty()) refuse();
  for (const auto& step : *path) {
    if (step.is_string()) {
      steps.emplace_back(step.get<std::string>());
    } else if (step.is_number_unsigned()) {
      steps.emplace_back(step.get<std::size_t>());
    } else {
      refuse();
    }
  }
  return steps;
}

std::string changed_text(const std::string& text, const Json& change) {
  if (!change.is_object()) throw InputError("changes: expected objects");
  const auto path = path_in(change, "path");
  if (change.contains("name")) return deck_with_name(text, path, required_text(change, "name"));
  if (change.contains("exchange")) return deck_with_order(text, path, path_in(change, "exchange"));
  const bool removes = change.contains("value") && change["value"].is_null();
  return removes ? deck_without(text, path) : deck_with_value(text, path, required_text(change, "value"));
}

/// A path as `--set` has it: names of the elements of arrays where they have one.
std::string override_path(const detail::DeckTable& root, const DeckPath& path) {
  std::string text;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto* key = std::get_if<std::string>(&path[i]);
    const auto* element = detail::value_at(root, detail::DeckSteps(path).first(i + 1));
    const auto name = key != nullptr       ? *key
                      : element != nullptr ? detail::element_name(*element, std::get<std::size_t>(path[i]))
                                           : std::to_string(std::get<std::size_t>(path[i]));
    text = detail::joined(text, name);
  }
  return text;
}

/// The command that runs a deck with the changes while its text stays as it is. Nothing where overrides would not give
/// the same deck, as for elements that are added to arrays.
Json override_command(const Json& request, const std::string& text, const std::string& edited) {
  const auto name = optional_text(request, "name");
  if (name.empty()) return nullptr;
  const auto before = detail::parse_deck(name, text);
  auto root = before;
  Command command = {.arguments = {"run", name}};
  std::vector<Mistake> mistakes;
  for (const auto& change : request["changes"]) {
    if (!change.contains("value")) return nullptr;
    const auto value = change["value"].is_null() ? "" : change["value"].get<std::string>();
    const auto override_text = fmt::format("{}={}", override_path(before, path_in(change, "path")), value);
    detail::apply_override(root, "--set", override_text, mistakes);
    command.arguments.emplace_back("--set");
    command.arguments.push_back(override_text);
  }
  const bool is_same = mistakes.empty() && detail::is_same(root, detail::parse_deck(name, edited));
  return is_same ? Json(shown(command)) : Json(nullptr);
}

}  // namespace

Json edited_deck(const Json& request) {
  const auto text = required_text(request, "text");
  const auto changes = request.find("changes");
  if (changes == request.end() || !changes->is_array() || changes->empty()) {
    throw InputError("changes: expected one or more");
  }
  auto edited = text;
  for (const auto& change : *changes) edited = changed_text(edited, change);
  auto json = json_of_text(edited);
  json["command"] = override_command(request, text, edited);
  return json;
}

}  // namespace breccia::studio
