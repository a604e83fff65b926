#include "tables/table_layout.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/trimmed.hpp"
#include "tables/column_meaning.hpp"

namespace breccia::detail {

namespace {

using Choices = std::span<const ColumnChoice>;

constexpr std::size_t fewest_known_columns = 2;
constexpr std::size_t longest_preamble = 200;

std::size_t known_columns_of(const CsvRecord& record, Choices choices) {
  return static_cast<std::size_t>(std::ranges::count_if(
      record.fields, [choices](const auto& field) { return meaning_of(field, choices).has_value(); }));
}

/// The first of the comments at the top of a text that names two known columns, as in `##Temp./°C;E'/MPa`.
std::optional<TableLayout> layout_in_comment(std::string_view text, char separator, Choices choices) {
  for (std::size_t line = 1; line <= longest_preamble && !text.empty(); ++line) {
    const auto end = text.find('\n');
    auto comment = trimmed(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!comment.starts_with('#')) continue;
    comment.remove_prefix(std::min(comment.find_first_not_of('#'), comment.size()));
    auto record = CsvRecords(comment, separator).next();
    if (!record) continue;
    record->line = line;
    const auto known = known_columns_of(*record, choices);
    if (known >= fewest_known_columns) return TableLayout{separator, *std::move(record), known};
  }
  return std::nullopt;
}

bool is_row_of_numbers(const CsvRecord& record) {
  constexpr std::ptrdiff_t fewest = 2;
  return std::ranges::count_if(record.fields, [](std::string field) {
           std::ranges::replace(field, ',', '.');
           return parse_number(field).has_value();
         }) >= fewest;
}

/// The likely names among records without known names: the uppermost of the lines of texts directly above a row of
/// numbers, with as many values as the row; or else the first record.
CsvRecord likely_names(std::span<const CsvRecord> records) {
  if (records.empty()) return {};
  for (auto numbers = records.begin(); numbers != records.end(); ++numbers) {
    if (!is_row_of_numbers(*numbers)) continue;
    const auto is_text_of_same_size = [&](const CsvRecord& record) {
      return record.fields.size() == numbers->fields.size() && !is_row_of_numbers(record);
    };
    auto names = numbers;
    while (names != records.begin() && is_text_of_same_size(*(names - 1))) --names;
    if (names != numbers) return *names;
  }
  return records.front();
}

/// The layout with the first of some records that names two known columns.
std::optional<TableLayout> named_layout(std::span<const CsvRecord> records, char separator, Choices choices) {
  for (const auto& record : records) {
    const auto known = known_columns_of(record, choices);
    if (known >= fewest_known_columns) return TableLayout{separator, record, known};
  }
  return std::nullopt;
}

/// The layout with the likely names.
TableLayout likely_layout(std::span<const CsvRecord> records, char separator, Choices choices) {
  auto names = likely_names(records);
  const auto known = known_columns_of(names, choices);
  return {separator, std::move(names), known};
}

TableLayout layout_with(std::string_view text, char separator, Choices choices) {
  std::vector<CsvRecord> preamble;
  CsvRecords records(text, separator);
  while (preamble.size() < longest_preamble) {
    auto record = records.next();
    if (!record) break;
    preamble.push_back(*std::move(record));
  }
  if (auto layout = named_layout(preamble, separator, choices)) return *std::move(layout);
  if (auto layout = layout_in_comment(text, separator, choices)) return *std::move(layout);
  return likely_layout(preamble, separator, choices);
}

/// The digits and commas of a number, without its sign and exponent; nothing if the value is not a number with commas.
std::optional<std::string_view> digits_with_commas(std::string_view value) {
  constexpr std::string_view digits = "0123456789";
  if (value.starts_with('+') || value.starts_with('-')) value.remove_prefix(1);
  if (const auto letter = value.find_first_of("eE"); letter != std::string_view::npos) {
    auto exponent = value.substr(letter + 1);
    if (exponent.starts_with('+') || exponent.starts_with('-')) exponent.remove_prefix(1);
    if (exponent.empty() || exponent.find_first_not_of(digits) != std::string_view::npos) return std::nullopt;
    value = value.substr(0, letter);
  }
  const bool is_number = value.find(',') != std::string_view::npos &&
                         value.find_first_of(digits) != std::string_view::npos &&
                         value.find_first_not_of("0123456789,") == std::string_view::npos;
  return is_number ? std::optional(value) : std::nullopt;
}

/// Whether the commas among digits could separate thousands, as in 2,000 or 1,234,567.
bool may_have_thousands(std::string_view digits) {
  constexpr std::size_t group = 3;
  auto comma = digits.find(',');
  if (comma == 0 || comma > group || digits.front() == '0') return false;
  while (comma != std::string_view::npos) {
    digits.remove_prefix(comma + 1);
    comma = digits.find(',');
    if (digits.substr(0, comma).size() != group) return false;
  }
  return true;
}

/// Whether each column is read: the columns with known names, or all columns if no name is known.
std::vector<bool> columns_read(const TableLayout& layout, Choices choices) {
  std::vector<bool> are_read;
  for (const auto& name : layout.header.fields) {
    are_read.push_back(layout.known_columns == 0 || meaning_of(name, choices).has_value());
  }
  return are_read;
}

/// Whether the numbers in the columns that are read have commas and no points. Throws InputError if the commas could
/// also separate thousands.
bool has_decimal_commas(std::span<const CsvRecord> records, const TableLayout& layout, Choices choices) {
  const auto are_read = columns_read(layout, choices);
  bool has_comma = false, has_thousands = true;
  std::string example;
  for (const auto& record : records) {
    if (record.line <= layout.header.line) continue;
    for (std::size_t i = 0; i < std::min(record.fields.size(), are_read.size()); ++i) {
      if (!are_read[i]) continue;
      const auto& field = record.fields[i];
      if (field.find('.') != std::string::npos && parse_number(field)) return false;
      const auto digits = digits_with_commas(field);
      if (!digits) continue;
      has_comma = true;
      if (example.empty()) example = field;
      has_thousands = has_thousands && may_have_thousands(*digits);
    }
  }
  if (has_comma && has_thousands) {
    throw InputError(fmt::format(
        "the comma of \"{}\" may be a decimal one or part thousands; write points, or no commas in thousands",
        example));
  }
  return has_comma;
}

/// The text with a tab instead of every two or more blanks within a line.
std::string with_tabs(std::string_view text) {
  std::string result;
  std::size_t blanks = 0;
  for (const char letter : text) {
    if (letter == ' ') {
      ++blanks;
      continue;
    }
    const bool is_at_margin = result.empty() || result.back() == '\n' || letter == '\n';
    if (blanks > 0 && !is_at_margin) result += blanks > 1 ? '\t' : ' ';
    blanks = 0;
    result += letter;
  }
  return result;
}

}  // namespace

LaidOutTable table_in_text(std::string_view text, Choices choices) {
  auto best = layout_with(text, ',', choices);
  for (const char separator : {';', '\t'}) {
    auto other = layout_with(text, separator, choices);
    const auto merit = [](const TableLayout& layout) {
      return std::tuple(layout.known_columns, layout.header.fields.size());
    };
    if (merit(other) > merit(best)) best = std::move(other);
  }
  if (best.known_columns < fewest_known_columns) {
    const auto tabbed = with_tabs(text);
    auto by_blanks = layout_with(tabbed, '\t', choices);
    if (by_blanks.known_columns >= fewest_known_columns) {
      auto records = csv_records(tabbed, '\t');
      by_blanks.separator = ' ';
      by_blanks.has_decimal_commas = has_decimal_commas(records, by_blanks, choices);
      return {std::move(by_blanks), std::move(records)};
    }
  }
  auto records = csv_records(text, best.separator);
  if (best.separator != ',') best.has_decimal_commas = has_decimal_commas(records, best, choices);
  return {std::move(best), std::move(records)};
}

bool names_columns(std::span<const CsvRecord> rows, Choices choices) {
  return named_layout(rows.first(std::min(rows.size(), longest_preamble)), '\t', choices).has_value();
}

LaidOutTable table_in_sheet(std::vector<CsvRecord> rows, Choices choices) {
  const auto first = std::span<const CsvRecord>(rows).first(std::min(rows.size(), longest_preamble));
  auto named = named_layout(first, '\t', choices);
  auto layout = named ? *std::move(named) : likely_layout(first, '\t', choices);
  layout.has_decimal_commas = has_decimal_commas(rows, layout, choices);
  return {std::move(layout), std::move(rows)};
}

}  // namespace breccia::detail
