#include "repeated_tables.hpp"

#include <algorithm>
#include <utility>

namespace breccia::detail {

RepeatedTables repeated_tables(std::vector<CsvRecord> records, const std::vector<std::string>& names,
                               const std::vector<std::string>& units,
                               const std::function<bool(const CsvRecord&)>& may_be_row) {
  RepeatedTables tables;
  auto begin = records.begin();
  for (auto next = begin; begin != records.end(); begin = next) {
    const auto end = std::ranges::find(begin, records.end(), names, &CsvRecord::fields);
    const bool is_last = end == records.end();
    for (auto record = begin; record != end; ++record) {
      if (is_last || may_be_row(*record)) tables.rows.push_back(std::move(*record));
    }
    if (is_last) break;
    ++tables.count;
    next = end + 1;
    if (next != records.end() && next->fields == units) ++next;
  }
  return tables;
}

}  // namespace breccia::detail
