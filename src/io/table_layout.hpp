#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "breccia/io/column_choice.hpp"

#include "csv_records.hpp"

namespace breccia::detail {

/// The layout of a table in a file.
struct TableLayout {
  char separator = ',';
  CsvRecord header;  ///< the first row that names two known columns, or else such a comment, or the first row
  std::size_t known_columns = 0;  ///< number of known columns in the header
  bool has_decimal_commas = false;
};

/// Determines the layout of a text: the separator for which most known columns are found and, if that is not a comma,
/// decimal commas if there are no decimal points.
TableLayout layout_of(std::string_view text, std::span<const ColumnChoice> choices = {});

}  // namespace breccia::detail
