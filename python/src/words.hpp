#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/words.hpp"

namespace breccia::python {

/// The value of an enumeration that a word of an argument stands for. Throws InputError, with all words, for any other.
template <HasWords Enum>
Enum value_of(const std::string& argument, const std::string& word) {
  if (const auto value = value_named<Enum>(word)) return *value;
  std::vector<std::string> known;
  known.reserve(words<Enum>.size());
  for (const auto& [name, value] : words<Enum>) known.push_back(fmt::format("\"{}\"", name));
  throw InputError(fmt::format("{}: expected {}, got \"{}\"", argument, fmt::join(known, " or "), word));
}

}  // namespace breccia::python
