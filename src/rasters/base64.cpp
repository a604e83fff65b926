#include "rasters/base64.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace breccia {

namespace {

constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::int8_t no_digit = -1, white_space = -2, padding = -3;

/// The meaning of each byte: the value of a digit, or one of the constants above.
constexpr auto base64_meaning = [] {
  std::array<std::int8_t, 256> meaning{};
  meaning.fill(no_digit);
  for (std::size_t value = 0; value < base64_digits.size(); ++value) {
    meaning[static_cast<unsigned char>(base64_digits[value])] = static_cast<std::int8_t>(value);
  }
  for (const char blank : {' ', '\t', '\r', '\n'}) meaning[static_cast<unsigned char>(blank)] = white_space;
  meaning['='] = padding;
  return meaning;
}();

}  // namespace

std::string encode_base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k])) : 0U;
    };
    const std::uint32_t group = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? base64_digits[group >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

std::optional<std::string> decode_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int digits = 0, paddings = 0;
  for (const char character : text) {
    const auto meaning = base64_meaning[static_cast<unsigned char>(character)];
    if (meaning == white_space) continue;
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
