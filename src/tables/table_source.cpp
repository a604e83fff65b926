#include "tables/table_source.hpp"

#include <cstddef>
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

constexpr std::size_t fewest_known_columns = 2;

std::string name_of(TextEncoding encoding) {
  if (encoding == TextEncoding::utf16) return "UTF-16";
  return encoding == TextEncoding::latin1 ? "Latin-1" : "UTF-8";
}

/// A refusal of a workbook with several tables or, among several sheets, none.
[[noreturn]] void refuse_sheets(const std::vector<TableSource>& sheets, bool have_tables) {
  std::vector<std::string> names;
  names.reserve(sheets.size());
  for (const auto& one : sheets) names.push_back(shown_value(one.sheet));
  if (have_tables) {
    throw InputError(
        fmt::format("the sheets {} have a table each; hide the others, or save the one that is meant as CSV",
                    fmt::join(names, ", ")));
  }
  throw InputError(
      fmt::format("none of the sheets {} has a line with the names of two known columns", fmt::join(names, ", ")));
}

/// The sheet of a workbook that has the table.
TableSource sheet_with_table(std::string_view bytes, std::span<const ColumnChoice> choices) {
  std::vector<TableSource> filled, tables;
  for (auto& [name, text] : sheets_of(bytes)) {
    if (text.find_first_not_of("\t\n ") == std::string::npos) continue;
    auto layout = layout_of(text, choices);
    auto& found = layout.known_columns < fewest_known_columns ? filled : tables;
    found.push_back({std::move(text), "", std::move(name), std::move(layout)});
  }
  if (tables.size() > 1) refuse_sheets(tables, true);
  if (!tables.empty()) return std::move(tables.front());
  if (filled.size() > 1) refuse_sheets(filled, false);
  if (filled.empty()) throw InputError("no visible sheet of the workbook has values");
  return std::move(filled.front());
}

}  // namespace

TableSource read_table_source(const std::filesystem::path& path, std::span<const ColumnChoice> choices) {
  auto bytes = read_text(path);
  const bool is_workbook = is_archive(bytes);
  TableText table;
  if (!is_workbook) table = decoded_table(path, std::move(bytes));
  try {
    if (is_workbook) return sheet_with_table(bytes, choices);
    auto layout = layout_of(table.text, choices);
    return {std::move(table.text), name_of(table.encoding), "", std::move(layout)};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

}  // namespace breccia::detail
