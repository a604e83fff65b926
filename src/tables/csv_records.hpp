#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace breccia::detail {

/// A row of a CSV file, without spaces around its values.
struct CsvRecord {
  std::size_t line = 0;  ///< number of its first line, from 1
  std::vector<std::string> fields;
};

/// Reads a CSV text row by row. Empty lines and lines that begin with # are skipped. A value that begins with a double
/// quote ends at the next quote that is not doubled; in between, separators and line breaks belong to the value, and ""
/// is a quote. A quote within an unquoted value is an ordinary character, as in G".
class CsvRecords {
 public:
  /// The text must outlive this object.
  explicit CsvRecords(std::string_view text, char separator = ',') : text_(text), separator_(separator) {}

  /// The next row, or nothing at the end.
  std::optional<CsvRecord> next();

 private:
  void skip_line();
  std::string read_value();
  std::string read_quoted(std::size_t closing);
  /// The text before the next separator or line break, without spaces around it.
  std::string read_bare();
  [[nodiscard]] bool is_at_end_of_line() const { return at_ == text_.size() || text_[at_] == '\n'; }

  std::string_view text_;
  char separator_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/// All rows of a CSV text.
std::vector<CsvRecord> csv_records(std::string_view text, char separator);

/// Reads a number, which may be infinite but not NaN; nothing for any other text.
std::optional<double> parse_number(std::string_view text);

}  // namespace breccia::detail
