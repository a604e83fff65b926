#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace breccia::detail {

/// Throws InputError if a file is not a text of bytes but UTF-16, a picture or the binary format of a spreadsheet.
void refuse_binary(const std::filesystem::path& path, std::string_view text);

/// Throws InputError, with line and column, at the first byte that is not UTF-8.
void require_utf8(const std::filesystem::path& path, std::string_view text);

/// The text of a file as UTF-8 without a byte order mark. A file that is not UTF-8 is read as Latin-1, in which some
/// instruments write "°". Throws FileError, and InputError as refuse_binary().
std::string read_table_text(const std::filesystem::path& path);

}  // namespace breccia::detail
