#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "breccia/tables/column_choice.hpp"

#include "tables/csv_records.hpp"

namespace breccia::detail {

/// The layout of a table in a file.
struct TableLayout {
  char separator = ',';
  CsvRecord header;  ///< the first row that names two known columns, or else such a comment, or the likely names
  std::size_t known_columns = 0;  ///< number of known columns in the header
  bool has_decimal_commas = false;
  /// Columns are separated by two blanks and more; `separator` is the tab of with_tabs().
  bool is_aligned_by_blanks = false;
};

/// The text with a tab instead of every two or more blanks within a line.
std::string with_tabs(std::string_view text);

/// Determines the layout of a text: the separator for which most known columns are found, or blanks if none has any,
/// and, if that is not a comma, decimal commas if there are no decimal points.
TableLayout layout_of(std::string_view text, std::span<const ColumnChoice> choices = {});

}  // namespace breccia::detail
