#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace breccia {

/// A table of named columns, read from a CSV file.
class CsvTable {
 public:
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] std::size_t rows() const noexcept { return lines_.size(); }
  /// The names of the columns in the order of the file.
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  [[nodiscard]] bool has(const std::string& name) const;
  /// A column of numbers. Throws InputError, with the names of the existing columns, when it is missing.
  [[nodiscard]] const std::vector<double>& numbers(const std::string& name) const;
  /// A column that was given to read_csv() as a text column. Throws InputError when it is missing.
  [[nodiscard]] const std::vector<std::string>& text(const std::string& name) const;
  /// Location of a row, `file:line`, for messages about it.
  [[nodiscard]] std::string location(std::size_t row) const;

 private:
  friend class CsvReader;
  [[noreturn]] void throw_missing(const std::string& name) const;

  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::vector<std::size_t> lines_;  ///< line number of each row in the file
  std::map<std::string, std::vector<double>, std::less<>> numbers_;
  std::map<std::string, std::vector<std::string>, std::less<>> text_;
};

/// Reads a CSV file that Breccia has written: a header line with the names of the columns, then one row per line. All
/// columns hold numbers (`inf` is allowed) except the text columns. Empty lines, lines that begin with #, spaces around
/// values, double quotes (with separators and line breaks within them), CRLF and a UTF-8 byte order mark are allowed.
/// For tables of other origin use read_measured_table(). Throws InputError with all mistakes in the file
/// (FileMistakes), and FileError when the file cannot be read.
CsvTable read_csv(const std::filesystem::path& path, const std::vector<std::string>& text_columns = {});

/// A column to be written.
struct CsvColumn {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::string>> values;
};

/// Writes columns of equal length atomically. Each number has the fewest digits that are read back as the same double;
/// text of any kind is read back unchanged. Each line of the comment gets a leading "# ". Throws FileError.
void write_csv(const std::filesystem::path& path, const std::vector<CsvColumn>& columns, std::string_view comment = {});

}  // namespace breccia
