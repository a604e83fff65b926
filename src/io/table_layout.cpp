#include "table_layout.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <tuple>

#include "column_meaning.hpp"

namespace breccia::detail {

namespace {

std::size_t known_columns_of(const CsvRecord& record) {
  return static_cast<std::size_t>(
      std::ranges::count_if(record.fields, [](const auto& field) { return meaning_of(field).has_value(); }));
}

TableLayout layout_with(std::string_view text, char separator) {
  constexpr std::size_t fewest = 2;
  constexpr std::size_t longest_preamble = 200;
  TableLayout first{separator, {}, 0, false};
  CsvRecords records(text, separator);
  for (std::size_t i = 0; i < longest_preamble; ++i) {
    auto record = records.next();
    if (!record) break;
    const auto known = known_columns_of(*record);
    if (known >= fewest) return {separator, *std::move(record), known, false};
    if (i == 0) first = {separator, *std::move(record), known, false};
  }
  return first;
}

/// Of the numbers in a table: whether commas stand in them and no points.
bool has_decimal_commas(std::string_view text, const TableLayout& layout) {
  CsvRecords records(text, layout.separator);
  bool has_comma = false;
  while (const auto record = records.next()) {
    if (record->line <= layout.header.line) continue;
    for (const auto& field : record->fields) {
      if (field.find('.') != std::string::npos && parse_number(field)) return false;
      has_comma = has_comma || field.find(',') != std::string::npos;
    }
  }
  return has_comma;
}

}  // namespace

TableLayout layout_of(std::string_view text) {
  auto best = layout_with(text, ',');
  for (const char separator : {';', '\t'}) {
    auto other = layout_with(text, separator);
    const auto merit = [](const TableLayout& layout) {
      return std::tuple(layout.known_columns, layout.header.fields.size());
    };
    if (merit(other) > merit(best)) best = std::move(other);
  }
  if (best.separator != ',') best.has_decimal_commas = has_decimal_commas(text, best);
  return best;
}

}  // namespace breccia::detail
