#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace breccia::detail {

/// A sheet of a workbook as the text of a table: a line for each row from the first row on, so that a line has the
/// number of its row, and tabs between the cells.
struct WorkbookSheet {
  std::string name;
  std::string text;
};

/// Whether bytes begin as a ZIP archive does, which a workbook is.
bool is_archive(std::string_view bytes);

/// The visible sheets of a workbook in the format .xlsx (Office Open XML, ECMA-376, Part 1, chapter 18). A cell has the
/// value that is stored, whatever digits its format shows; of a formula, the value when the workbook was saved. What a
/// format shows as another number than the stored one (dates, times of day, percentages), and formulas without a value,
/// become texts that say so, which no reader takes for numbers. Throws InputError with the reason for other archives,
/// and for damaged and encrypted ones.
std::vector<WorkbookSheet> sheets_of(std::string_view bytes);

}  // namespace breccia::detail
