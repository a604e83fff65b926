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
  /// A column of numbers. Throws InputError, naming the columns there are, when this one is missing.
  [[nodiscard]] const std::vector<double>& numbers(const std::string& name) const;
  /// A column of text, one of those that read_csv was told of. Throws InputError when it is missing.
  [[nodiscard]] const std::vector<std::string>& text(const std::string& name) const;
  /// `file:line` of a row, to begin a message about it.
  [[nodiscard]] std::string place(std::size_t row) const;

 private:
  friend class CsvReader;
  [[noreturn]] void throw_missing(const std::string& name) const;

  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::vector<std::size_t> lines_;  ///< of the file, for each row
  std::map<std::string, std::vector<double>, std::less<>> numbers_;
  std::map<std::string, std::vector<std::string>, std::less<>> text_;
};

/// Reads a CSV file: a header line with the names of the columns, then one row a line. All columns hold numbers (`inf`
/// is one) except those named as text. Empty lines, lines that begin with #, spaces around values, double quotes (with
/// separators and line breaks within them), CRLF and a UTF-8 byte order mark are allowed. For tables that Breccia
/// writes itself; read_measured_table reads what people and instruments write. Throws InputError with what is wrong
/// (FileMistakes), and FileError when the file cannot be read.
CsvTable read_csv(const std::filesystem::path& path, const std::vector<std::string>& text_columns = {});

/// A column to be written.
struct CsvColumn {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::string>> values;
};

/// Writes columns of equal length atomically; numbers are the shortest that read back as the same double, and so is
/// text of any kind. Each line of the comment gets a leading "# ". Throws FileError.
void write_csv(const std::filesystem::path& path, const std::vector<CsvColumn>& columns, std::string_view comment = {});

}  // namespace breccia
