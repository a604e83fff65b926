#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace breccia::detail {

/// Throws InputError where a file holds no text of bytes: UTF-16, a picture, the own format of a spreadsheet.
void refuse_binary(const std::filesystem::path& path, std::string_view text);

/// Throws InputError, with line and column, at the first byte that is not UTF-8.
void require_utf8(const std::filesystem::path& path, std::string_view text);

/// A file as UTF-8 without a byte order mark; what is not UTF-8 is taken for Latin-1, in which instruments write "°".
/// Throws FileError, and InputError as refuse_binary does.
std::string read_table_text(const std::filesystem::path& path);

}  // namespace breccia::detail
