#include "breccia/io/printable.hpp"

#include <cstdint>

#include <fmt/format.h>

#include "utf8.hpp"

namespace breccia {

namespace detail {

std::size_t length_of_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<std::uint8_t>(text[i]) : 0U; };
  const auto first = byte(0);
  if (first < 0x80) return text.empty() ? 0 : 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return 0;
  }
  // Overlong encodings, surrogates of UTF-16, or code points beyond the last one.
  const bool is_none = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) > 0x9f) ||
                       (first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) > 0x8f);
  return is_none ? 0 : length;
}

}  // namespace detail

namespace {

/// Whether a text begins with a control character. Those beyond ASCII, U+0080 to U+009F, have two bytes.
bool begins_with_control(std::string_view text) {
  const auto first = static_cast<std::uint8_t>(text[0]);
  return first < 0x20 || first == 0x7f || (first == 0xc2 && static_cast<std::uint8_t>(text[1]) < 0xa0);
}

}  // namespace

bool is_printable(std::string_view text) {
  while (!text.empty()) {
    const auto length = detail::length_of_character(text);
    if (length == 0 || begins_with_control(text)) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto length = detail::length_of_character(text);
    if (length == 0) {
      result += fmt::format("\\x{:02x}", static_cast<std::uint8_t>(text[0]));
      text.remove_prefix(1);
      continue;
    }
    if (begins_with_control(text)) {
      result += fmt::format("\\u{:04x}", static_cast<std::uint8_t>(text[length - 1]));
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return result;
}

}  // namespace breccia
