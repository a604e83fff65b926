#include "tables/workbook.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"
#include "tables/number_formats.hpp"
#include "tables/xml_elements.hpp"
#include "tables/zip_archive.hpp"

namespace breccia::detail {
namespace {

/// A part of the workbook as XML.
pugi::xml_document parsed(const ZipArchive& archive, const std::string& part) {
  pugi::xml_document document;
  const auto bytes = archive.entry(part);
  const auto result = document.load_buffer(bytes.data(), bytes.size());
  if (!result && !bytes.empty()) {
    throw InputError(fmt::format("{} in the workbook is damaged XML: {}", part, result.description()));
  }
  return document;
}

/// The texts of an element `si` or `is`: of its own or of its parts in several fonts, without phonetic readings.
std::string text_of(const pugi::xml_node& rich) {
  std::string text;
  for (const auto& part : rich.children()) {
    const auto name = local_name(part);
    if (name == "t") text += part.text().get();
    if (name == "r") text += child(part, "t").text().get();
  }
  return text;
}

/// The column of a reference such as "AB12", from 0; nothing without letters.
std::optional<std::size_t> column_of(std::string_view reference) {
  constexpr std::size_t letters = 26, most = 16384;
  std::size_t column = 0;
  while (!reference.empty() && reference.front() >= 'A' && reference.front() <= 'Z' && column <= most) {
    column = column * letters + static_cast<std::size_t>(reference.front() - 'A') + 1;
    reference.remove_prefix(1);
  }
  if (column == 0) return std::nullopt;
  if (column > most) throw InputError("a cell of the workbook lies beyond column 16384");
  return column - 1;
}

/// A value between tabs, in double quotes where it would otherwise be read as something else.
std::string as_field(std::string value) {
  std::ranges::replace_if(
      value, [](char letter) { return letter == '\n' || letter == '\r' || letter == '\t'; }, ' ');
  if (!value.starts_with('"')) return value;
  std::string quoted = "\"";
  for (const char letter : value) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

/// Reads the cells of sheets.
class SheetReader {
 public:
  explicit SheetReader(const ZipArchive& archive, const std::string& folder)
      : formats_(number_formats(parsed(archive, folder + "styles.xml").document_element())) {
    const auto shared = parsed(archive, folder + "sharedStrings.xml");
    for (const auto& one : children(shared.document_element(), "si")) strings_.push_back(text_of(one));
  }

  /// The rows of a sheet, all of the same number of cells.
  [[nodiscard]] std::string text(const pugi::xml_node& worksheet) const {
    std::map<std::size_t, std::vector<std::string>> rows;
    std::size_t row = 0, width = 0;
    for (const auto& stored : children(child(worksheet, "sheetData"), "row")) {
      row = stored.attribute("r").as_ullong(row + 1);
      auto cells = cells_of(stored);
      width = std::max(width, cells.size());
      if (!cells.empty()) rows[row] = std::move(cells);
    }
    return joined(std::move(rows), width);
  }

 private:
  [[nodiscard]] static std::string joined(std::map<std::size_t, std::vector<std::string>> rows, std::size_t width) {
    constexpr std::size_t most_rows = 1048576, most_cells = std::size_t{1} << 26U;
    const auto last = rows.empty() ? 0 : rows.rbegin()->first;
    if (last > most_rows || rows.size() * width > most_cells) {
      throw InputError(fmt::format("a sheet of {} rows and {} columns is too large", last, width));
    }
    std::string text;
    std::size_t line = 1;
    for (auto& [row, cells] : rows) {
      for (; line < row; ++line) text += '\n';
      cells.resize(width);
      for (std::size_t i = 0; i < width; ++i) text += (i > 0 ? "\t" : "") + cells[i];
    }
    return text + '\n';
  }

  [[nodiscard]] std::vector<std::string> cells_of(const pugi::xml_node& row) const {
    std::vector<std::string> cells;
    for (const auto& cell : children(row, "c")) {
      const auto column = column_of(cell.attribute("r").value()).value_or(cells.size());
      if (cells.size() <= column) cells.resize(column + 1);
      cells[column] = field_of(cell);
    }
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
    return cells;
  }

  [[nodiscard]] std::string field_of(const pugi::xml_node& cell) const {
    const std::string_view type = cell.attribute("t").as_string("n");
    const auto value = child(cell, "v");
    if (type == "inlineStr") return as_field(text_of(child(cell, "is")));
    if (!value && child(cell, "f")) return "a formula without its value; save it in a spreadsheet";
    if (type == "s") return as_field(shared_string(value));
    // In quotes, since a line that begins with # is a comment.
    if (type == "e") return fmt::format("\"{}\"", value.text().get());
    if (type == "b") return value.text().as_bool() ? "TRUE" : "FALSE";
    if (type == "d") return fmt::format("{} stored as a date", value.text().get());
    if (type != "n") return as_field(value.text().get());
    return number_of(value.text().get(), cell.attribute("s").as_ullong());
  }

  [[nodiscard]] const std::string& shared_string(const pugi::xml_node& value) const {
    const auto index = value.text().as_ullong(strings_.size());
    if (index >= strings_.size()) throw InputError("a cell of the workbook has a text that is not stored in it");
    return strings_[index];
  }

  /// A stored number; with a remark where the format of the cell shows another one.
  [[nodiscard]] std::string number_of(std::string number, std::size_t style) const {
    if (number.empty() || style >= formats_.size()) return number;
    switch (formats_[style]) {
      case NumberFormat::date:
        return number + " shown as a date; format it as a number";
      case NumberFormat::percentage:
        return number + " shown in %; format it as a number";
      default:
        return number;
    }
  }

  std::vector<NumberFormat> formats_;  ///< by the style of a cell
  std::vector<std::string> strings_;   ///< the texts that cells share
};

/// The targets of the relations of a part, by their identities; paths within the archive.
std::map<std::string, std::string> relations_of(const ZipArchive& archive, const std::string& folder,
                                                const std::string& part) {
  std::map<std::string, std::string> targets;
  const auto relations = parsed(archive, fmt::format("{}_rels/{}.rels", folder, part));
  for (const auto& one : children(relations.document_element(), "Relationship")) {
    const std::string target = one.attribute("Target").value();
    targets[one.attribute("Id").value()] = target.starts_with('/') ? target.substr(1) : folder + target;
  }
  return targets;
}

/// The identity of the relation of a sheet, whose attribute has the prefix of another namespace.
std::string relation_of(const pugi::xml_node& sheet) {
  for (const auto& attribute : sheet.attributes()) {
    if (std::string_view(attribute.name()).ends_with(":id")) return attribute.value();
  }
  return {};
}

}  // namespace

bool is_archive(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

std::vector<WorkbookSheet> sheets_of(std::string_view bytes) {
  const std::string folder = "xl/", book = "workbook.xml";
  const ZipArchive archive(bytes);
  const auto workbook = parsed(archive, folder + book);
  if (!workbook.document_element()) {
    throw InputError("expected text or a workbook in the format .xlsx, got another archive; save the table as CSV");
  }
  const SheetReader reader(archive, folder);
  const auto targets = relations_of(archive, folder, book);
  std::vector<WorkbookSheet> sheets;
  for (const auto& sheet : children(child(workbook.document_element(), "sheets"), "sheet")) {
    if (std::string_view(sheet.attribute("state").as_string("visible")) != "visible") continue;
    const std::string name = sheet.attribute("name").value();
    const auto target = targets.find(relation_of(sheet));
    if (target == targets.end()) {
      throw InputError(fmt::format("the sheet {} is not in the workbook", shown_value(name)));
    }
    sheets.push_back({name, reader.text(parsed(archive, target->second).document_element())});
  }
  return sheets;
}

}  // namespace breccia::detail
