#include "tables/table_source.hpp"

#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"
#include "io/text_encoding.hpp"
#include "io/text_file.hpp"
#include "tables/workbook.hpp"

namespace breccia::detail {
namespace {

std::string name_of(TextEncoding encoding) {
  if (encoding == TextEncoding::utf16) return "UTF-16";
  return encoding == TextEncoding::latin1 ? "Latin-1" : "UTF-8";
}

/// A refusal of a workbook with several tables or, among several sheets, none.
[[noreturn]] void refuse_sheets(const std::vector<WorkbookSheet>& sheets, bool have_tables) {
  std::vector<std::string> names;
  names.reserve(sheets.size());
  for (const auto& one : sheets) names.push_back(shown_value(one.name));
  if (have_tables) {
    throw InputError(
        fmt::format("the sheets {} have a table each; hide the others, or save the one that is meant as CSV",
                    fmt::join(names, ", ")));
  }
  throw InputError(
      fmt::format("none of the sheets {} has a line with the names of two known columns", fmt::join(names, ", ")));
}

/// The sheet of a workbook that has the table.
WorkbookSheet sheet_with_table(std::string_view bytes, std::span<const ColumnChoice> choices) {
  std::vector<WorkbookSheet> others, tables;
  for (auto& sheet : sheets_of(bytes)) {
    if (sheet.rows.empty()) continue;
    auto& found = names_columns(sheet.rows, choices) ? tables : others;
    found.push_back(std::move(sheet));
  }
  if (tables.size() > 1) refuse_sheets(tables, true);
  if (!tables.empty()) return std::move(tables.front());
  if (others.size() > 1) refuse_sheets(others, false);
  if (others.empty()) throw InputError("no visible sheet of the workbook has values");
  return std::move(others.front());
}

}  // namespace

TableSource read_table_source(const std::filesystem::path& path, std::span<const ColumnChoice> choices) {
  auto bytes = read_text(path);
  const bool is_workbook = is_archive(bytes);
  TableText text;
  if (!is_workbook) text = decoded_table(path, std::move(bytes));
  auto place = path.string();
  try {
    if (!is_workbook) return {table_in_text(text.text, choices), name_of(text.encoding), ""};
    auto [sheet, rows] = sheet_with_table(bytes, choices);
    place += ": sheet " + shown_value(sheet);
    return {table_in_sheet(std::move(rows), choices), "", std::move(sheet)};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", place, error.what()));
  }
}

}  // namespace breccia::detail
