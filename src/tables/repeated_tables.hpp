#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "tables/csv_records.hpp"

namespace breccia::detail {

/// The rows of a file that has tables of the same columns one below the other, as rheometers write one for each
/// temperature.
struct RepeatedTables {
  std::vector<CsvRecord> rows;           ///< rows of all tables, without names and units
  std::vector<std::size_t> other_names;  ///< lines with the names of a table of other columns
  std::vector<std::size_t> other_units;  ///< lines with other units than those of the first table
  std::size_t count = 1;                 ///< number of tables
};

/// The rules that distinguish the lines of a file.
struct TableLines {
  const std::vector<std::string>& names;  ///< names of the columns of the first table
  const std::vector<std::string>& units;  ///< units in the row below the names; empty if there is none
  const std::function<bool(const CsvRecord&)>& may_be_row;  ///< whether a line may be a row, possibly an incomplete one
  const std::function<bool(const CsvRecord&)>& names_columns;  ///< whether a line names columns
};

/// Finds the tables in the records below the names and the units of the first one. A further table begins with the same
/// names and units. Between two tables, lines that are neither rows nor names are left out.
RepeatedTables repeated_tables(std::vector<CsvRecord> records, const TableLines& lines);

}  // namespace breccia::detail
