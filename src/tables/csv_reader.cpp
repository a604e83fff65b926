#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"
#include "io/text_encoding.hpp"
#include "tables/csv.hpp"
#include "tables/csv_records.hpp"

namespace breccia {

/// Reads one file row by row and collects its mistakes.
class CsvReader {
 public:
  CsvReader(const std::filesystem::path& path, const std::vector<std::string>& text_columns)
      : text_columns_(text_columns), mistakes_(path) {
    table_.path_ = path;
  }

  CsvTable read() {
    const auto text = detail::read_table_text(table_.path_).text;
    detail::CsvRecords records(text);
    const auto header = records.next();
    if (!header) throw InputError(fmt::format("{}: expected a header line", table_.path_.string()));
    read_header(*header);
    mistakes_.refuse();
    while (const auto record = records.next()) read_row(*record);
    mistakes_.refuse();
    return std::move(table_);
  }

 private:
  [[nodiscard]] std::string location(std::size_t line) const {
    return fmt::format("{}:{}", table_.path_.string(), line);
  }

  void read_header(const detail::CsvRecord& header) {
    table_.names_ = header.fields;
    for (auto name = table_.names_.begin(); name != table_.names_.end(); ++name) {
      const bool is_number = detail::parse_number(*name).has_value();
      if (name->empty() || is_number) {
        mistakes_.add(location(header.line), "expected the name of a column (the first line is the header)",
                      shown_value(*name));
      } else if (std::find(table_.names_.begin(), name, *name) != name) {
        mistakes_.add(location(header.line), fmt::format("two columns are called \"{}\"", *name));
      } else if (is_text(*name)) {
        table_.text_[*name];
      } else {
        table_.numbers_[*name];
      }
    }
  }

  void read_row(const detail::CsvRecord& record) {
    const auto& names = table_.names_;
    const auto& fields = record.fields;
    if (fields.size() != names.size()) {
      mistakes_.add(location(record.line), fmt::format("expected {} values ({})", names.size(), fmt::join(names, ", ")),
                    fmt::format("{}", fields.size()));
      return;
    }
    table_.lines_.push_back(record.line);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (is_text(names[i])) {
        table_.text_[names[i]].push_back(fields[i]);
      } else if (const auto number = detail::parse_number(fields[i])) {
        table_.numbers_[names[i]].push_back(*number);
      } else {
        mistakes_.add(location(record.line), fmt::format("{}: expected a number", names[i]), shown_value(fields[i]));
      }
    }
  }

  [[nodiscard]] bool is_text(const std::string& name) const {
    return std::ranges::find(text_columns_, name) != text_columns_.end();
  }

  const std::vector<std::string>& text_columns_;
  CsvTable table_;
  FileMistakes mistakes_;
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

std::string CsvTable::location(std::size_t row) const {
  return fmt::format("{}:{}", path_.string(), lines_.at(row));
}

void CsvTable::throw_missing(const std::string& name) const {
  throw InputError(
      fmt::format(R"({}: no column "{}"; it has "{}")", path_.string(), name, fmt::join(names_, "\", \"")));
}

}  // namespace breccia
