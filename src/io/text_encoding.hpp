#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace breccia::detail {

/// The encoding of the characters of a table.
enum class TextEncoding { utf8, latin1, utf16 };

/// A table as UTF-8 text without a byte order mark, whose lines end with a line feed.
struct TableText {
  std::string text;
  TextEncoding encoding = TextEncoding::utf8;  ///< encoding of the file
};

/// Whether bytes begin as a ZIP archive does, which a workbook of a spreadsheet is.
bool is_archive(std::string_view bytes);

/// Throws InputError if a file is not a text of bytes but UTF-16, a picture or the binary format of a spreadsheet.
void refuse_binary(const std::filesystem::path& path, std::string_view text);

/// Throws InputError, with line and column, at the first byte that is not UTF-8.
void require_utf8(const std::filesystem::path& path, std::string_view text);

/// The text of a table from the bytes of its file. A file that is not UTF-8 is read as Latin-1, in which some
/// instruments write "°", or, with a byte order mark or zero bytes, as UTF-16. Throws InputError as refuse_binary() for
/// other files.
TableText decoded_table(const std::filesystem::path& path, std::string bytes);

/// The text of a table in a file, as decoded_table() has it. Throws FileError, and InputError as it does.
TableText read_table_text(const std::filesystem::path& path);

}  // namespace breccia::detail
