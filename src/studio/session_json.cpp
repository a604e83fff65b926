#include "studio/session_json.hpp"

#include <optional>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "studio/deck_json.hpp"
#include "studio/terminal_text.hpp"

namespace breccia::studio {
namespace {

/// The words of the states of a run.
const char* word_of(RunState state) {
  switch (state) {
    case RunState::running:
      return "running";
    case RunState::done:
      return "done";
    case RunState::failed:
      return "failed";
    case RunState::stopped:
      return "stopped";
  }
  return "";
}

/// Adds to the JSON of a deck what its text means: its tree, or where it is not TOML.
void add_tree(Json& deck, const std::string& text) {
  deck["tree"] = nullptr;
  deck["mistakes"] = Json::array();
  try {
    deck["tree"] = deck_tree_json(text);
  } catch (const InputError& error) {
    deck["mistakes"] = json_of(mistakes_in(error.what(), "deck"));
  }
}

}  // namespace

std::string required_text(const Json& request, const std::string& key) {
  const auto entry = request.find(key);
  if (entry == request.end() || !entry->is_string()) throw InputError(fmt::format("{}: expected text", key));
  return entry->get<std::string>();
}

std::string optional_text(const Json& request, const std::string& key) {
  const auto entry = request.find(key);
  if (entry == request.end() || entry->is_null()) return "";
  if (!entry->is_string()) throw InputError(fmt::format("{}: expected text", key));
  return entry->get<std::string>();
}

Json json_of(const DeckText& deck) {
  Json json = {{"name", deck.name}, {"text", deck.text}, {"version", deck.version}};
  add_tree(json, deck.text);
  return json;
}

Json json_of_text(const std::string& text) {
  Json json = {{"text", text}};
  add_tree(json, text);
  return json;
}

Json json_of(const std::vector<ShownMistake>& mistakes) {
  auto json = Json::array();
  for (const auto& mistake : mistakes) {
    json.push_back({{"line", mistake.line}, {"column", mistake.column}, {"message", mistake.message}});
  }
  return json;
}

Json json_of(const Command& command, const FinishedCommand& finished) {
  return {{"command", shown(command)}, {"exit", finished.exit_code}, {"output", finished.output}};
}

Json json_of(const RunStatus& run) {
  const auto share = share_in(run.live_line);
  Json json = {{"id", run.id},           {"command", shown(run.command)},
               {"name", run.deck},       {"state", word_of(run.state)},
               {"exit", nullptr},        {"output", run.output},
               {"live", run.live_line},  {"share", nullptr},
               {"seconds", run.seconds}, {"results", run.results.generic_string()},
               {"report", nullptr}};
  if (run.exit_code) json["exit"] = *run.exit_code;
  if (share) json["share"] = *share;
  return json;
}

}  // namespace breccia::studio
