#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "studio/command_line.hpp"
#include "studio/folder.hpp"
#include "studio/running_study.hpp"

namespace breccia::studio {

/// The texts and objects that the page sends and gets (docs/studio.md).
using Json = nlohmann::ordered_json;

/// The text of an entry of a request. Throws InputError if it has no such text.
std::string required_text(const Json& request, const std::string& key);

/// The text of an entry of an object in a request; empty if there is none, or no object. Throws InputError for another
/// value.
std::string optional_text(const Json& request, const std::string& key);

Json json_of(const DeckText& deck);
/// What the text of a deck means: {"text", "tree", "mistakes"}; the tree is null where the text is not TOML.
Json json_of_text(const std::string& text);
Json json_of(const std::vector<ShownMistake>& mistakes);
Json json_of(const Command& command, const FinishedCommand& finished);
Json json_of(const RunStatus& run);

}  // namespace breccia::studio
