#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/io/csv.hpp"
#include "breccia/io/nearest_name.hpp"
#include "breccia/io/text_file.hpp"

namespace breccia {

namespace {

constexpr std::size_t most_mistakes_shown = 20;

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// The values of a line. A value may stand in double quotes, within which a comma is a letter and "" a quote.
std::vector<std::string> split_line(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool doubled = quoted && line.substr(i).starts_with("\"\"");
    if (line[i] == '"' && !doubled) {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
    if (doubled) ++i;
  }
  for (auto& field : fields) field = std::string(trimmed(field));
  return fields;
}

/// A number, which may be infinite but not NaN.
std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || std::isnan(number)) return std::nullopt;
  return number;
}

}  // namespace

/// Reads one file line by line and gathers what is wrong with it.
class CsvReader {
 public:
  CsvReader(const std::filesystem::path& path, const std::vector<std::string>& text_columns)
      : text_columns_(text_columns) {
    table_.path_ = path;
  }

  CsvTable read() {
    const std::string content = read_text(table_.path_);
    std::string_view rest = content;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    for (; !rest.empty(); ++line_) {
      const auto line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(line.size() + 1, rest.size()));
      if (trimmed(line).empty() || trimmed(line).starts_with('#')) continue;
      if (table_.names_.empty()) {
        read_header(line);
        if (!mistakes_.empty()) break;
      } else {
        read_row(split_line(line));
      }
    }
    if (table_.names_.empty()) throw InputError(fmt::format("{}: expected a header line", table_.path_.string()));
    throw_mistakes();
    return std::move(table_);
  }

 private:
  void mistake(const std::string& message) {
    mistakes_.push_back(fmt::format("{}:{}: {}", table_.path_.string(), line_, message));
  }

  void read_header(std::string_view line) {
    table_.names_ = split_line(line);
    for (auto name = table_.names_.begin(); name != table_.names_.end(); ++name) {
      const bool is_number = parse_number(*name).has_value();
      if (name->empty() || is_number) {
        mistake(fmt::format("expected the name of a column, got \"{}\" (the first line is the header)", *name));
      } else if (std::find(table_.names_.begin(), name, *name) != name) {
        mistake(fmt::format("two columns are called \"{}\"", *name));
      } else if (is_text(*name)) {
        table_.text_[*name];
      } else {
        table_.numbers_[*name];
      }
    }
  }

  void read_row(const std::vector<std::string>& fields) {
    const auto& names = table_.names_;
    if (fields.size() != names.size()) {
      mistake(fmt::format("expected {} values ({}), got {}", names.size(), fmt::join(names, ", "), fields.size()));
      return;
    }
    table_.lines_.push_back(line_);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (is_text(names[i])) {
        table_.text_[names[i]].push_back(fields[i]);
      } else if (const auto number = parse_number(fields[i])) {
        table_.numbers_[names[i]].push_back(*number);
      } else {
        const auto got = fields[i].empty() ? "nothing" : fmt::format("\"{}\"", fields[i]);
        mistake(fmt::format("{}: expected a number, got {}", names[i], got));
      }
    }
  }

  void throw_mistakes() {
    if (mistakes_.empty()) return;
    if (mistakes_.size() > most_mistakes_shown) {
      const auto more = mistakes_.size() - most_mistakes_shown;
      mistakes_.resize(most_mistakes_shown);
      mistakes_.push_back(fmt::format("{}: {} more", table_.path_.string(), more));
    }
    throw InputError(fmt::format("{}", fmt::join(mistakes_, "\n")));
  }

  [[nodiscard]] bool is_text(const std::string& name) const {
    return std::ranges::find(text_columns_, name) != text_columns_.end();
  }

  const std::vector<std::string>& text_columns_;
  CsvTable table_;
  std::size_t line_ = 1;
  std::vector<std::string> mistakes_;
};

CsvTable read_csv(const std::filesystem::path& path, const std::vector<std::string>& text_columns) {
  return CsvReader(path, text_columns).read();
}

bool CsvTable::has(const std::string& name) const {
  return std::ranges::find(names_, name) != names_.end();
}

const std::vector<double>& CsvTable::numbers(const std::string& name) const {
  const auto column = numbers_.find(name);
  if (column == numbers_.end()) throw_missing(name);
  return column->second;
}

const std::vector<std::string>& CsvTable::text(const std::string& name) const {
  const auto column = text_.find(name);
  if (column == text_.end()) throw_missing(name);
  return column->second;
}

std::string CsvTable::place(std::size_t row) const {
  return fmt::format("{}:{}", path_.string(), lines_.at(row));
}

void CsvTable::throw_missing(const std::string& name) const {
  throw InputError(
      fmt::format(R"({}: no column "{}"; it has "{}")", path_.string(), name, fmt::join(names_, "\", \"")));
}

}  // namespace breccia
