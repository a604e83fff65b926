#include "text_encoding.hpp"

#include <cstdint>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"

#include "utf8.hpp"

namespace breccia::detail {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_utf16(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return true;
  // In UTF-16 an ASCII character is followed or preceded by a zero byte.
  const auto is_letter = [](char byte) { return byte > '\0'; };
  if (text.size() < 2) return false;
  return (text[0] == '\0' && is_letter(text[1])) || (is_letter(text[0]) && text[1] == '\0');
}

/// The number of bytes of the UTF-8 part at the beginning of a text.
std::size_t length_of_utf8(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size()) {
    const auto step = length_of_character(text.substr(length));
    if (step == 0) break;
    length += step;
  }
  return length;
}

std::string from_latin1(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    const auto byte = static_cast<std::uint8_t>(letter);
    if (byte < 0x80) {
      result += letter;
    } else {
      result += static_cast<char>(0xc0U | (byte >> 6U));
      result += static_cast<char>(0x80U | (byte & 0x3fU));
    }
  }
  return result;
}

}  // namespace

void refuse_binary(const std::filesystem::path& path, std::string_view text) {
  if (is_utf16(text)) throw InputError(fmt::format("{}: saved as UTF-16; save it as UTF-8", path.string()));
  if (text.find('\0') != std::string_view::npos) {
    throw InputError(fmt::format("{}: expected text, got a binary file, such as a picture", path.string()));
  }
}

void require_utf8(const std::filesystem::path& path, std::string_view text) {
  const auto valid = length_of_utf8(text);
  if (valid == text.size()) return;
  std::size_t line = 1, column = 1;
  for (std::size_t i = 0; i < valid; i += length_of_character(text.substr(i))) {
    column = text[i] == '\n' ? 1 : column + 1;
    if (text[i] == '\n') ++line;
  }
  throw InputError(fmt::format("{}:{}:{}: the byte \\x{:02x} is not UTF-8; save the file as UTF-8", path.string(), line,
                               column, static_cast<std::uint8_t>(text[valid])));
}

std::string read_table_text(const std::filesystem::path& path) {
  auto text = read_text(path);
  refuse_binary(path, text);
  if (length_of_utf8(text) != text.size()) return from_latin1(text);
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

}  // namespace breccia::detail
