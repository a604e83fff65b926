#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace breccia {

/// A value of an enumeration, or of a type with few values, and its word in decks, tables and messages.
template <class Enum>
using Word = std::pair<std::string_view, Enum>;

/// The words of an enumeration, in the order in which they are offered to users. Each enumeration that users write or
/// read defines its own words, `template <> inline constexpr auto words<Load> = std::to_array<Word<Load>>({...})`,
/// beside itself.
template <class Enum>
inline constexpr std::nullptr_t words = nullptr;

/// An enumeration, or another type, for which `words` is defined.
template <class Enum>
concept HasWords = !std::is_same_v<decltype(words<Enum>), const std::nullptr_t>;

/// The word for a value.
template <HasWords Enum>
std::string name_of(Enum value) {
  for (const auto& [word, meaning] : words<Enum>) {
    if (meaning == value) return std::string(word);
  }
  return {};
}

/// The value that a word stands for; nothing for any other word.
template <HasWords Enum>
std::optional<Enum> value_named(std::string_view name) {
  for (const auto& [word, meaning] : words<Enum>) {
    if (word == name) return meaning;
  }
  return std::nullopt;
}

}  // namespace breccia
