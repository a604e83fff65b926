#pragma once

#include <string>

#include "studio/session_json.hpp"

namespace breccia::studio {

/// Makes the changes of a request in the text of a deck, one after the other (docs/studio.md). Returns the text with
/// its tree, and the command with which a shell does the same for one run, if there is one.
Json edited_deck(const Json& request);

}  // namespace breccia::studio
