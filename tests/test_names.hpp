#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "breccia/words.hpp"

namespace breccia::test {

/// A text as part of the name of a test, which has letters, digits and single underscores: "4 x 40" is "4_x_40".
inline std::string as_test_name(std::string_view text) {
  std::string name;
  for (const char sign : text) {
    if (std::isalnum(static_cast<unsigned char>(sign)) != 0) {
      name += sign;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  if (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

template <HasWords Enum>
std::string words_of(Enum value) {
  return as_test_name(name_of(value));
}
template <class... Enums>
std::string words_of(const std::tuple<Enums...>& values) {
  const auto joined = [](const auto&... value) { return (... + fmt::format("_{}", words_of(value))); };
  return as_test_name(std::apply(joined, values));
}

/// Names the tests of an enumeration, or of combinations of several, by the words of their values.
inline constexpr auto by_words = [](const auto& chosen) { return words_of(chosen.param); };

/// Names tests by the printed text of their parameters.
inline constexpr auto by_value = [](const auto& chosen) { return as_test_name(testing::PrintToString(chosen.param)); };

/// Names typed tests of the dimensions two and three.
struct DimensionNames {
  template <class Dimension>
  static std::string GetName(int /*number*/) {  // NOLINT(readability-identifier-naming): GoogleTest calls it
    return Dimension::value == 2 ? "InThePlane" : "InSpace";
  }
};

}  // namespace breccia::test
