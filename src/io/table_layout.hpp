#pragma once

#include <cstddef>
#include <string_view>

#include "csv_records.hpp"

namespace breccia::detail {

/// How a table is written.
struct TableLayout {
  char separator = ',';
  CsvRecord header;               ///< the first row that names two known columns, or else the first row
  std::size_t known_columns = 0;  ///< that the header names
  bool has_decimal_commas = false;
};

/// Finds out how a text is written: with the separator by which most known columns are named and, where that is not the
/// comma, with decimal commas when there are no decimal points.
TableLayout layout_of(std::string_view text);

}  // namespace breccia::detail
