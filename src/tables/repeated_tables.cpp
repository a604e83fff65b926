#include "tables/repeated_tables.hpp"

#include <algorithm>
#include <utility>

namespace breccia::detail {

RepeatedTables repeated_tables(std::vector<CsvRecord> records, const TableLines& lines) {
  RepeatedTables tables;
  const auto last = std::find_if(records.rbegin(), records.rend(), [&](const CsvRecord& record) {
                      return record.fields == lines.names;
                    }).base();
  for (auto record = records.begin(); record != records.end(); ++record) {
    const bool is_in_last = record >= last;
    if (record->fields == lines.names) {
      ++tables.count;
      const auto next = record + 1;
      if (next == records.end() || lines.may_be_row(*next)) continue;
      if (next->fields != lines.units) tables.other_units.push_back(next->line);
      record = next;
    } else if (lines.names_columns(*record)) {
      tables.other_names.push_back(record->line);
    } else if (is_in_last || lines.may_be_row(*record)) {
      tables.rows.push_back(std::move(*record));
    }
  }
  return tables;
}

}  // namespace breccia::detail
