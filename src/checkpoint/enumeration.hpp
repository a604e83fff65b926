#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/words.hpp"

#include "checkpoint/state.hpp"

namespace breccia {

/// Reads a value of an enumeration from the number that it was written as. Throws FileError for a number that no value
/// has.
template <HasWords Enum>
Enum read_enumeration(const StateReader& state, const std::string& name) {
  const auto number = state.integer(name);
  for (const auto& [word, value] : words<Enum>) {
    if (static_cast<std::int64_t>(value) == number) return value;
  }
  throw FileError(fmt::format("{}: the number {} of {} has no meaning", state.path(), number, name));
}

}  // namespace breccia
