#pragma once

#include <string>

namespace breccia::cli {

/// Where one who reads the help finds a deck to begin with and the keys of a deck.
std::string where_to_begin();

}  // namespace breccia::cli
