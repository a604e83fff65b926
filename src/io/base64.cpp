#include "base64.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace breccia {

namespace {

constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::int8_t no_digit = -1, space = -2, padding = -3;

/// What each byte means: the value of a digit, or one of the above.
constexpr auto base64_meaning = [] {
  std::array<std::int8_t, 256> meaning{};
  meaning.fill(no_digit);
  for (std::size_t value = 0; value < base64_digits.size(); ++value) {
    meaning[static_cast<unsigned char>(base64_digits[value])] = static_cast<std::int8_t>(value);
  }
  for (const char blank : {' ', '\t', '\r', '\n'}) meaning[static_cast<unsigned char>(blank)] = space;
  meaning['='] = padding;
  return meaning;
}();

}  // namespace

std::optional<std::string> decode_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int digits = 0, paddings = 0;
  for (const char character : text) {
    const auto meaning = base64_meaning[static_cast<unsigned char>(character)];
    if (meaning == space) continue;
    if (meaning == no_digit || (meaning != padding && paddings > 0)) return {};
    if (meaning == padding) ++paddings;
    group = group << 6U | (meaning == padding ? 0U : static_cast<std::uint32_t>(meaning));
    if (++digits < 4) continue;
    if (paddings > 2) return {};
    for (int i = 0; i < 3 - paddings; ++i) bytes += static_cast<char>(group >> (16U - 8U * static_cast<unsigned>(i)));
    digits = paddings = 0;
    group = 0;
  }
  if (digits != 0) return {};
  return bytes;
}

}  // namespace breccia
