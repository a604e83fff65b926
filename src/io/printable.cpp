#include "io/printable.hpp"

#include <cstdint>

#include <fmt/format.h>

#include "io/utf8.hpp"

namespace breccia {

namespace {

/// Whether a text begins with a control character. The control characters beyond ASCII, U+0080 to U+009F, have two
/// bytes.
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
