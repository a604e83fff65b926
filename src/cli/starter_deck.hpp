#pragma once

#include <string_view>

namespace breccia::cli {

/// The text of examples/starter.toml, embedded in the program when it is built.
std::string_view starter_deck();

}  // namespace breccia::cli
