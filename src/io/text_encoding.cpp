#include "io/text_encoding.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "io/utf8.hpp"

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

void append_character(std::string& text, std::uint32_t code) {
  const auto add = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  constexpr std::uint32_t continuation = 0x80, six_bits = 0x3f;
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xc0U | (code >> 6U));
    add(continuation | (code & six_bits));
  } else if (code < 0x10000) {
    add(0xe0U | (code >> 12U));
    add(continuation | ((code >> 6U) & six_bits));
    add(continuation | (code & six_bits));
  } else {
    add(0xf0U | (code >> 18U));
    add(continuation | ((code >> 12U) & six_bits));
    add(continuation | ((code >> 6U) & six_bits));
    add(continuation | (code & six_bits));
  }
}

/// UTF-16 of either byte order as UTF-8; nothing if a character is incomplete.
std::optional<std::string> from_utf16(std::string_view text) {
  if (text.size() % 2 != 0) return std::nullopt;
  const bool is_big_endian = text.starts_with("\xFE\xFF") || text[0] == '\0';
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<std::uint8_t>(text[at]), second = static_cast<std::uint8_t>(text[at + 1]);
    return is_big_endian ? (std::uint32_t{first} << 8U) | second : (std::uint32_t{second} << 8U) | first;
  };
  std::string result;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    auto code = unit(i);
    const bool is_first_half = code >= 0xd800 && code < 0xdc00, is_second_half = code >= 0xdc00 && code < 0xe000;
    if (is_second_half) return std::nullopt;
    if (is_first_half) {
      i += 2;
      if (i == text.size() || unit(i) < 0xdc00 || unit(i) >= 0xe000) return std::nullopt;
      code = 0x10000U + ((code - 0xd800U) << 10U) + (unit(i) - 0xdc00U);
    }
    append_character(result, code);
  }
  return result;
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

bool is_archive(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

void refuse_binary(const std::filesystem::path& path, std::string_view text) {
  if (text.starts_with("\xD0\xCF\x11\xE0")) {
    throw InputError(
        fmt::format("{}: expected text, got a document of an old format (.xls) or with a password; save its table as "
                    "CSV, or in the format .xlsx without a password",
                    path.string()));
  }
  if (is_archive(text)) {
    throw InputError(fmt::format(
        "{}: expected text, got a workbook of a spreadsheet or an archive; save its table as CSV", path.string()));
  }
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

TableText decoded_table(const std::filesystem::path& path, std::string bytes) {
  TableText table = {std::move(bytes)};
  auto& [text, encoding] = table;
  if (is_utf16(text)) {
    encoding = TextEncoding::utf16;
    auto decoded = from_utf16(text);
    if (!decoded) throw InputError(fmt::format("{}: UTF-16 with half a character; save it as UTF-8", path.string()));
    text = *std::move(decoded);
  }
  refuse_binary(path, text);
  if (length_of_utf8(text) != text.size()) {
    encoding = TextEncoding::latin1;
    text = from_latin1(text);
  }
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  // On old systems lines end with a carriage return alone.
  if (text.find('\n') == std::string::npos) std::ranges::replace(text, '\r', '\n');
  return table;
}

TableText read_table_text(const std::filesystem::path& path) {
  return decoded_table(path, read_text(path));
}

}  // namespace breccia::detail
