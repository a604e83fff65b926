#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "tables/csv.hpp"

namespace breccia {

namespace {

std::size_t rows(const CsvColumn& column) {
  return std::visit([](const auto& values) { return values.size(); }, column.values);
}

/// The text, in double quotes if it contains special characters.
std::string escaped(const std::string& text) {
  const bool has_spaces_around = text.starts_with(' ') || text.ends_with(' ');
  if (text.find_first_of(",\"#\r\n\t") == std::string::npos && !has_spaces_around) return text;
  std::string quoted(1, '"');
  for (const char letter : text) quoted.append(letter == '"' ? 2 : 1, letter);
  quoted += '"';
  return quoted;
}

void append(std::string& text, const CsvColumn& column, std::size_t row) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&column.values)) {
    fmt::format_to(std::back_inserter(text), "{}", (*numbers)[row]);
  } else {
    text += escaped(std::get<std::vector<std::string>>(column.values)[row]);
  }
}

std::string commented(std::string_view comment) {
  std::string text;
  while (!comment.empty()) {
    const auto line = comment.substr(0, comment.find('\n'));
    text += fmt::format("# {}\n", line);
    comment.remove_prefix(std::min(line.size() + 1, comment.size()));
  }
  return text;
}

}  // namespace

void write_csv(const std::filesystem::path& path, const std::vector<CsvColumn>& columns, std::string_view comment) {
  const std::size_t row_count = columns.empty() ? 0 : rows(columns.front());
  std::string text = commented(comment);
  for (const auto& column : columns) {
    if (rows(column) != row_count) {
      throw InputError(
          fmt::format("{}: column {} has {} rows, the first {}", path.string(), column.name, rows(column), row_count));
    }
    if (&column != columns.data()) text += ',';
    text += escaped(column.name);
  }
  text += '\n';
  for (std::size_t row = 0; row < row_count; ++row) {
    for (const auto& column : columns) {
      if (&column != columns.data()) text += ',';
      append(text, column, row);
    }
    text += '\n';
  }
  write_text(path, text);
}

}  // namespace breccia
