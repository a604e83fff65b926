#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "csv_records.hpp"

namespace breccia::detail {

/// The rows of a file that has tables of the same columns one below the other, as rheometers write one for each
/// temperature.
struct RepeatedTables {
  std::vector<CsvRecord> rows;  ///< of all tables, without names and units
  std::size_t count = 1;        ///< number of tables
};

/// Finds the tables in the records below the names, and the units if there are any, of the first one. A further table
/// begins with the same names and units. Lines between two tables for which `may_be_row` is false are left out.
RepeatedTables repeated_tables(std::vector<CsvRecord> records, const std::vector<std::string>& names,
                               const std::vector<std::string>& units,
                               const std::function<bool(const CsvRecord&)>& may_be_row);

}  // namespace breccia::detail
