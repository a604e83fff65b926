#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tables/csv_records.hpp"

namespace breccia::detail {

/// A sheet of a workbook.
struct WorkbookSheet {
  std::string name;
  std::vector<CsvRecord> rows;  ///< those with values, by their numbers as lines; all of the same number of cells
};

/// The visible sheets of a workbook in the format .xlsx (Office Open XML, ECMA-376, Part 1, chapter 18). A cell has the
/// value that is stored, whatever digits its format shows; of a formula, the value when the workbook was saved. What a
/// format shows as another number than the stored one (dates, times of day, percentages, thousands), and formulas
/// without a value, become texts that say so, which no reader takes for numbers. Throws InputError with the reason for
/// other archives, and for damaged and encrypted ones.
std::vector<WorkbookSheet> sheets_of(std::string_view bytes);

}  // namespace breccia::detail
