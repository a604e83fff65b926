#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "breccia/tables/column_choice.hpp"

#include "tables/table_layout.hpp"

namespace breccia::detail {

/// A table as it stands in a text file or in a sheet of a workbook.
struct TableSource {
  LaidOutTable table;
  std::string encoding;  ///< of a text: "UTF-8", "Latin-1" or "UTF-16"; empty for a workbook
  std::string sheet;     ///< of a workbook: the name of the sheet; empty for a text
};

/// Reads a file that has a table. Of a workbook, the one visible sheet that names two known columns is taken, or else
/// its only sheet with values. Throws FileError, and InputError for files that are neither text nor a workbook, for
/// workbooks with several tables or none, and where the layout is ambiguous (table_in_text()).
TableSource read_table_source(const std::filesystem::path& path, std::span<const ColumnChoice> choices);

}  // namespace breccia::detail
