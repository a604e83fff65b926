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
  char separator = ',';  ///< a blank stands for two blanks and more, a tab for the cells of a sheet
  CsvRecord header;      ///< the first row that names two known columns, or else such a comment, or the likely names
  std::size_t known_columns = 0;  ///< number of known columns in the header
  bool has_decimal_commas = false;
};

/// The layout of a table and all rows of its file, the header among them.
struct LaidOutTable {
  TableLayout layout;
  std::vector<CsvRecord> rows;
};

/// Determines the layout of a text: the separator for which most known columns are found, or blanks if none has any,
/// and, if that is not a comma, decimal commas if there are no decimal points. Throws InputError where commas may be
/// decimal ones or part thousands.
LaidOutTable table_in_text(std::string_view text, std::span<const ColumnChoice> choices = {});

/// Whether one of the first rows of a sheet names two known columns.
bool names_columns(std::span<const CsvRecord> rows, std::span<const ColumnChoice> choices);

/// Determines the layout of the rows of a sheet; decimal commas are those of numbers that are stored as texts. Throws
/// as table_in_text().
LaidOutTable table_in_sheet(std::vector<CsvRecord> rows, std::span<const ColumnChoice> choices);

}  // namespace breccia::detail
