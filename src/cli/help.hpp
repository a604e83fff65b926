#pragma once

#include <string>

namespace breccia::cli {

/// The end of the help: how to get a first deck and the description of the keys of a deck.
std::string where_to_begin();

}  // namespace breccia::cli
