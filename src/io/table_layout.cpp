#include "table_layout.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <tuple>

#include <fmt/format.h>

#include "breccia/error.hpp"

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

/// Could the commas of a number part thousands, as in 2,000 or 1,234,567?
bool may_have_thousands(std::string_view field) {
  constexpr std::size_t group = 3;
  auto digits = field.find(',');
  if (digits == 0 || digits > group || field.front() == '0') return false;
  while (digits != std::string_view::npos) {
    field.remove_prefix(digits + 1);
    digits = field.find(',');
    const auto part = field.substr(0, digits);
    if (part.size() != group || part.find_first_not_of("0123456789") != std::string_view::npos) return false;
  }
  return true;
}

/// Of the numbers in a table: whether commas stand in them and no points. Throws InputError where they may as well part
/// thousands.
bool has_decimal_commas(std::string_view text, const TableLayout& layout) {
  CsvRecords records(text, layout.separator);
  bool has_comma = false, has_thousands = true;
  std::string example;
  while (const auto record = records.next()) {
    if (record->line <= layout.header.line) continue;
    for (const auto& field : record->fields) {
      if (field.find('.') != std::string::npos && parse_number(field)) return false;
      const bool is_parted =
          field.find(',') != std::string::npos && field.find_first_not_of("+-0123456789,eE") == std::string::npos;
      if (!is_parted) continue;
      has_comma = true;
      if (example.empty()) example = field;
      has_thousands = has_thousands && may_have_thousands(field);
    }
  }
  if (has_comma && has_thousands) {
    throw InputError(fmt::format(
        "the comma of \"{}\" may be a decimal one or part thousands; write points, or no commas in thousands",
        example));
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
