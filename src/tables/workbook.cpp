#include "tables/workbook.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"
#include "io/trimmed.hpp"
#include "tables/number_formats.hpp"
#include "tables/workbook_parts.hpp"
#include "tables/xml_elements.hpp"

namespace breccia::detail {
namespace {

constexpr std::size_t most_rows = 1048576, most_columns = 16384;

/// A text without the escapes of its characters as _xHHHH_ (ECMA-376, Part 1, 22.9.2.19), of which those of ASCII
/// occur, on one line and without blanks around it.
std::string plain(std::string_view stored) {
  constexpr std::size_t length = 7, digits = 4;
  std::string text;
  while (!stored.empty()) {
    unsigned code = 0x80;
    const bool has_form = stored.size() >= length && stored.starts_with("_x") && stored[length - 1] == '_';
    if (has_form) std::from_chars(stored.data() + 2, stored.data() + 2 + digits, code, 16);
    const bool is_escape = has_form && code < 0x80;
    text += is_escape ? static_cast<char>(code) : stored.front();
    stored.remove_prefix(is_escape ? length : 1);
  }
  std::ranges::replace_if(
      text, [](char letter) { return letter >= '\0' && letter < ' '; }, ' ');
  return std::string(trimmed(text));
}

/// The text of an element `si` or `is`: its own or that of its parts in several fonts, without phonetic readings.
std::string text_of(const pugi::xml_node& rich) {
  std::string text;
  for (const auto& part : rich.children()) {
    const auto name = local_name(part);
    if (name == "t") text += part.text().get();
    if (name == "r") text += child(part, "t").text().get();
  }
  return plain(text);
}

/// The column, from 0, of a cell of a row by its reference, such as "AB12". Throws InputError for a reference to
/// another row or beyond the last column.
std::size_t column_of(const std::string& reference, std::size_t row) {
  constexpr std::size_t letters = 26;
  std::size_t column = 0, length = 0;
  for (; length < reference.size() && reference[length] >= 'A' && reference[length] <= 'Z'; ++length) {
    column = column * letters + static_cast<std::size_t>(reference[length] - 'A') + 1;
    if (column > most_columns) break;
  }
  if (column == 0 || column > most_columns || reference.substr(length) != fmt::to_string(row)) {
    throw InputError(fmt::format("row {} of the workbook has a cell {}", row, shown_value(reference)));
  }
  return column - 1;
}

/// Reads the cells of sheets.
class SheetReader {
 public:
  explicit SheetReader(const WorkbookParts& parts)
      : formats_(number_formats(parts.related_as("styles").document_element())) {
    const auto shared = parts.related_as("sharedStrings");
    for (const auto& one : children(shared.document_element(), "si")) strings_.push_back(text_of(one));
  }

  /// The rows of a sheet that have values, all of the same number of cells.
  [[nodiscard]] std::vector<CsvRecord> rows_of(const pugi::xml_node& worksheet) const {
    std::map<std::size_t, std::map<std::size_t, std::string>> rows;
    std::size_t row = 0, width = 0;
    for (const auto& stored : children(child(worksheet, "sheetData"), "row")) {
      row = stored.attribute("r").as_ullong(row + 1);
      if (row == 0 || row > most_rows) throw InputError("a row of the workbook has a number out of range");
      auto cells = cells_of(stored, row);
      if (cells.empty()) continue;
      width = std::max(width, cells.rbegin()->first + 1);
      if (!rows.emplace(row, std::move(cells)).second) {
        throw InputError(fmt::format("row {} is in the workbook twice", row));
      }
    }
    return filled(rows, width);
  }

 private:
  [[nodiscard]] static std::vector<CsvRecord> filled(std::map<std::size_t, std::map<std::size_t, std::string>>& rows,
                                                     std::size_t width) {
    constexpr std::size_t most_cells = std::size_t{1} << 24U;
    if (rows.size() * width > most_cells) {
      throw InputError(fmt::format("a sheet of {} rows and {} columns is too large", rows.size(), width));
    }
    std::vector<CsvRecord> records;
    records.reserve(rows.size());
    for (auto& [row, cells] : rows) {
      CsvRecord record{row, std::vector<std::string>(width)};
      for (auto& [column, text] : cells) record.fields[column] = std::move(text);
      records.push_back(std::move(record));
    }
    return records;
  }

  /// The cells of a row that have values, by their columns.
  [[nodiscard]] std::map<std::size_t, std::string> cells_of(const pugi::xml_node& row, std::size_t number) const {
    std::map<std::size_t, std::string> cells;
    std::size_t next = 0;
    for (const auto& cell : children(row, "c")) {
      const std::string reference = cell.attribute("r").value();
      const auto column = reference.empty() ? next : column_of(reference, number);
      next = column + 1;
      auto text = text_of_cell(cell);
      if (!text.empty() && !cells.emplace(column, std::move(text)).second) {
        throw InputError(fmt::format("row {} of the workbook has the cell {} twice", number, shown_value(reference)));
      }
    }
    return cells;
  }

  [[nodiscard]] std::string text_of_cell(const pugi::xml_node& cell) const {
    const std::string_view type = cell.attribute("t").as_string("n");
    const auto value = child(cell, "v");
    const bool is_formula = static_cast<bool>(child(cell, "f"));
    if (type == "inlineStr") return text_of(child(cell, "is"));
    if (is_formula && type != "str" && std::string_view(value.text().get()).empty()) {
      return "a formula without its value; save it in a spreadsheet";
    }
    if (type == "s") return shared_string(value);
    if (type == "str" || type == "e") return plain(value.text().get());
    if (type == "b") return value.text().as_bool() ? "TRUE" : "FALSE";
    if (type == "d") return fmt::format("{} stored as a date", value.text().get());
    if (type != "n") throw InputError(fmt::format("the workbook has a cell of the type {}", shown_value(type)));
    return number_of(plain(value.text().get()), cell.attribute("s").as_ullong());
  }

  [[nodiscard]] const std::string& shared_string(const pugi::xml_node& value) const {
    const auto index = value.text().as_ullong(strings_.size());
    if (index >= strings_.size()) throw InputError("a cell of the workbook has a text that is not stored in it");
    return strings_[index];
  }

  /// A stored number; with a remark where the format of the cell shows another one.
  [[nodiscard]] std::string number_of(std::string number, std::size_t style) const {
    if (number.empty() || (formats_.empty() && style == 0)) return number;
    if (style >= formats_.size()) throw InputError("a cell of the workbook has a style that is not stored in it");
    switch (formats_[style]) {
      case NumberFormat::date:
        return number + " days, shown as a date or time";
      case NumberFormat::percentage:
        return number + " stored, shown as a percentage";
      case NumberFormat::scaled:
        return number + " stored, shown in thousands";
      default:
        return number;
    }
  }

  std::vector<NumberFormat> formats_;  ///< by the style of a cell
  std::vector<std::string> strings_;   ///< the texts that cells share
};

/// The identity of the relation to a sheet, whose attribute has the prefix of another namespace.
std::string relation_of(const pugi::xml_node& sheet) {
  for (const auto& attribute : sheet.attributes()) {
    if (std::string_view(attribute.name()).ends_with(":id")) return attribute.value();
  }
  return {};
}

}  // namespace

std::vector<WorkbookSheet> sheets_of(std::string_view bytes) {
  const WorkbookParts parts(bytes);
  const SheetReader reader(parts);
  const auto workbook = parts.workbook();
  std::vector<WorkbookSheet> sheets;
  for (const auto& sheet : children(child(workbook.document_element(), "sheets"), "sheet")) {
    if (std::string_view(sheet.attribute("state").as_string("visible")) != "visible") continue;
    const auto worksheet = parts.related(relation_of(sheet));
    sheets.push_back({sheet.attribute("name").value(), reader.rows_of(worksheet.document_element())});
  }
  return sheets;
}

}  // namespace breccia::detail
