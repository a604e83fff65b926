#include "breccia/tables/measured_table_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"
#include "tables/column_meaning.hpp"
#include "tables/column_units.hpp"
#include "tables/complex_modulus.hpp"
#include "tables/csv_records.hpp"
#include "tables/repeated_tables.hpp"
#include "tables/table_layout.hpp"
#include "tables/table_source.hpp"

namespace breccia {

/// Reads one file row by row and collects its mistakes.
class MeasuredTableReader {
 public:
  MeasuredTableReader(const std::filesystem::path& path, std::span<const ColumnChoice> choices)
      : choices_(choices), mistakes_(path) {
    table_.path_ = path;
  }

  MeasuredTable read() {
    auto source = detail::read_table_source(table_.path_, choices_);
    layout_ = std::move(source.table.layout);
    table_.reading_ = {source.encoding, source.sheet, layout_.separator, layout_.has_decimal_commas,
                       layout_.header.line};
    table_.names_ = layout_.header.fields;
    if (table_.names_.empty()) throw InputError(fmt::format("{}: expected a header line", table_.path_.string()));
    refuse_header();
    auto& rows = source.table.rows;
    std::erase_if(rows, [&](const auto& row) { return row.line <= layout_.header.line; });
    read_meanings();
    find_labels();
    std::vector<std::string> units;
    if (!rows.empty() && is_row_of_units(rows.front().fields)) {
      table_.reading_.has_row_of_units = true;
      units = rows.front().fields;
      add_units(units);
      rows.erase(rows.begin());
    }
    make_columns();
    mistakes_.refuse();
    auto tables = read_tables(std::move(rows), units);
    table_.reading_.tables = tables.count;
    for (auto& row : tables.rows) read_row(std::move(row));
    mistakes_.refuse();
    leave_out_twins();
    mistakes_.refuse();
    return std::move(table_);
  }

 private:
  [[nodiscard]] std::string location(std::size_t line) const { return table_.place_of_line(line); }

  /// Reports a file without names of columns, without separators or without a chosen column.
  void refuse_header() {
    if (table_.names_.size() == 1) {
      mistakes_.add(location(layout_.header.line), "expected columns, separated by commas, semicolons or tabs",
                    shown_value(table_.names_.front()));
    }
    mistakes_.refuse();
    for (const auto& choice : choices_) {
      const auto is_it = [&](const std::string& name) { return detail::is_choice_of(choice, name); };
      if (std::ranges::any_of(table_.names_, is_it)) continue;
      mistakes_.add("", fmt::format("no column {}; it has {}", shown_value(choice.name), table_.list_of_names()));
    }
    mistakes_.refuse();
    if (layout_.known_columns > 0) return;
    for (const auto& name : table_.names_) {
      if (!number_in(name)) continue;
      mistakes_.add(location(layout_.header.line), "expected the name of a column (the first line is the header)",
                    shown_value(name));
    }
    mistakes_.refuse();
  }

  void read_meanings() {
    for (const auto& name : table_.names_) meanings_.push_back(detail::meaning_of(name, choices_));
    const auto is_of = [](Quantity quantity) {
      return [quantity](const auto& meaning) { return meaning && meaning->quantity == quantity; };
    };
    const auto has = [&](Quantity quantity) { return std::ranges::any_of(meanings_, is_of(quantity)); };
    // In a table without particles or corners the columns of a particle and a filler may have texts.
    if (!has(Quantity::x)) std::ranges::replace_if(meanings_, is_of(Quantity::particle), std::nullopt);
    const bool has_particles = has(Quantity::diameter) || has(Quantity::axis_1) || has(Quantity::particle);
    if (!has_particles) std::ranges::replace_if(meanings_, is_of(Quantity::filler), std::nullopt);
    leave_out_what_follows(has);
  }

  /// Leaves out redundant columns: two columns determine a complex modulus, so further columns of it, such as a loss
  /// tangent beside storage and loss moduli, may have any content, and so may the time at which it was measured.
  void leave_out_what_follows(const detail::IsOfQuantity& has) {
    const auto is_chosen = [&](Quantity quantity) {
      return std::ranges::find(choices_, quantity, &ColumnChoice::quantity) != choices_.end();
    };
    const auto columns = detail::preferred_columns(has, is_chosen);
    const bool is_over_time = has(Quantity::modulus) || has(Quantity::compliance) || is_chosen(Quantity::time);
    if (columns && has(Quantity::angular_frequency) && !is_over_time) {
      std::ranges::replace_if(
          meanings_, [](const auto& meaning) { return meaning && meaning->quantity == Quantity::time; }, std::nullopt);
    }
    const auto is_needed = [&](Quantity quantity) {
      if (columns) return quantity == columns->modulus || quantity == columns->other;
      return quantity == Quantity::storage_modulus || quantity == Quantity::loss_modulus || is_chosen(quantity);
    };
    std::ranges::replace_if(
        meanings_,
        [&](const auto& meaning) {
          return meaning && detail::is_part_of_complex_modulus(meaning->quantity) && !is_needed(meaning->quantity);
        },
        std::nullopt);
  }

  /// The columns that distinguish the series in a table of results of Breccia.
  void find_labels() {
    const auto& names = table_.names_;
    const auto has = [&](std::string_view name) { return std::ranges::find(names, name) != names.end(); };
    if (!has("stage") || !has("boundary")) return;
    constexpr std::array<std::string_view, 6> labels{"task", "stage", "load", "boundary", "method", "cells"};
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (std::ranges::find(labels, names[i]) != labels.end()) label_columns_.push_back(i);
    }
  }

  /// Notes whether a row belongs to another series than the first row.
  void compare_labels(const std::vector<std::string>& fields) {
    std::vector<std::string> labels;
    for (const auto column : label_columns_) labels.push_back(fields[column]);
    if (table_.lines_.empty()) first_labels_ = labels;
    table_.has_several_series_ = table_.has_several_series_ || labels != first_labels_;
  }

  /// Whether a row contains the units of known columns that have no unit in their names.
  [[nodiscard]] bool is_row_of_units(const std::vector<std::string>& fields) const {
    bool tells_units = false;
    for (std::size_t i = 0; i < std::min(fields.size(), meanings_.size()); ++i) {
      if (number_in(fields[i])) return false;
      const bool lacks_unit = meanings_[i] && meanings_[i]->unit.empty();
      tells_units = tells_units || (lacks_unit && !fields[i].empty());
    }
    return tells_units;
  }

  /// The rows of all tables; reports tables with other columns or units.
  detail::RepeatedTables read_tables(std::vector<detail::CsvRecord> below, const std::vector<std::string>& units) {
    const std::function<bool(const detail::CsvRecord&)> is_row = [&](const auto& one) {
      return may_be_row(one.fields);
    };
    const std::function<bool(const detail::CsvRecord&)> are_names = [&](const auto& one) {
      return names_columns(one.fields);
    };
    auto tables = detail::repeated_tables(std::move(below), {table_.names_, units, is_row, are_names});
    for (const auto line : tables.other_names) {
      mistakes_.add(location(line), "another table begins here, with other columns: keep one of them in the file");
    }
    for (const auto line : tables.other_units) {
      mistakes_.add(location(line), "expected the units of the first table, as it has the same names");
    }
    mistakes_.refuse();
    return tables;
  }

  /// Whether a line has the names of two known columns and no number.
  [[nodiscard]] bool names_columns(const std::vector<std::string>& fields) const {
    constexpr std::ptrdiff_t fewest = 2;
    return std::ranges::none_of(fields, [&](const auto& field) { return number_in(field).has_value(); }) &&
           std::ranges::count_if(
               fields, [&](const auto& field) { return detail::meaning_of(field, choices_).has_value(); }) >= fewest;
  }

  void add_units(std::vector<std::string> fields) {
    // The first of several columns that are aligned by blanks may have no unit.
    if (layout_.separator == ' ' && fields.size() < table_.names_.size()) {
      fields.insert(fields.begin(), table_.names_.size() - fields.size(), "");
    }
    for (std::size_t i = 0; i < std::min(fields.size(), meanings_.size()); ++i) {
      if (!meanings_[i] || !meanings_[i]->unit.empty()) continue;
      auto unit = std::string_view(fields[i]);
      const bool has_brackets =
          (unit.starts_with('[') && unit.ends_with(']')) || (unit.starts_with('(') && unit.ends_with(')'));
      if (has_brackets) unit = unit.substr(1, unit.size() - 2);
      meanings_[i]->unit = std::string(unit);
    }
  }

  /// Selects the columns with known units; other columns are left out.
  void make_columns() {
    for (std::size_t i = 0; i < meanings_.size(); ++i) {
      if (!meanings_[i]) continue;
      const auto& name = table_.names_[i];
      const auto [quantity, kind, counts_cycles, unit] = *meanings_[i];
      try {
        sources_.push_back({i, detail::conversion_of(*meanings_[i])});
      } catch (const InputError& error) {
        table_.unknown_units_.push_back({quantity, fmt::format("the unit of {}: {}", shown_value(name), error.what())});
        continue;
      }
      const auto earlier =
          std::ranges::find_if(table_.columns_, [&, wanted = quantity, same = kind](const auto& column) {
            return column.quantity == wanted && column.kind == same;
          });
      if (earlier != table_.columns_.end()) {
        twins_.emplace_back(static_cast<std::size_t>(earlier - table_.columns_.begin()), table_.columns_.size());
      }
      table_.columns_.push_back({quantity, kind, name, unit, {}, {}});
    }
  }

  /// Leaves out columns that repeat the values of an earlier one, such as a frequency in Hz beside one in rad/s, and
  /// reports those with other values.
  void leave_out_twins() {
    constexpr double rounding = 1e-3, kelvins = 0.5;
    auto& columns = table_.columns_;
    for (const auto& [first, second] : twins_) {
      const auto& [one, other] = std::tie(columns[first], columns[second]);
      const bool is_temperature = one.quantity == Quantity::temperature;
      const bool are_equal = std::ranges::equal(one.values, other.values, [&](double a, double b) {
        return a == b || std::abs(a - b) <= (is_temperature ? kelvins : rounding * std::max(std::abs(a), std::abs(b)));
      });
      if (are_equal) continue;
      mistakes_.add("", fmt::format("{} says the same as {}, with other values; leave one of them out, or choose one",
                                    shown_value(other.name), shown_value(one.name)));
    }
    // NOLINTNEXTLINE(modernize-loop-convert): clang 14 does not know the views of the standard library
    for (auto twin = twins_.rbegin(); twin != twins_.rend(); ++twin) {
      columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(twin->second));
    }
  }

  /// Whether a line between two tables may be a row, possibly an incomplete one: it has numbers in two known columns,
  /// or one in the first of them and as many values as there are names.
  [[nodiscard]] bool may_be_row(const std::vector<std::string>& fields) const {
    const auto has_number = [&](const Source& source) {
      return source.place_in_row < fields.size() && number_in(fields[source.place_in_row]);
    };
    constexpr std::ptrdiff_t fewest = 2;
    const bool is_whole = fields.size() == table_.names_.size() && !sources_.empty();
    return (is_whole && has_number(sources_.front())) || std::ranges::count_if(sources_, has_number) >= fewest;
  }

  void read_row(detail::CsvRecord record) {
    auto& fields = record.fields;
    const auto count = table_.names_.size();
    if (std::ranges::all_of(fields, &std::string::empty)) return;
    while (fields.size() > count && fields.back().empty()) fields.pop_back();
    if (fields.size() != count) {
      const bool may_be_commas = layout_.separator == ',' && fields.size() > count;
      mistakes_.add(location(record.line),
                    fmt::format("expected {} values ({})", count, fmt::join(table_.names_, ", ")),
                    fmt::format("{}{}", fields.size(),
                                may_be_commas ? " (with decimal commas, separate the columns by semicolons)" : ""));
      return;
    }
    compare_labels(fields);
    table_.lines_.push_back(record.line);
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const auto& [place_in_row, conversion] = sources_[i];
      auto& column = table_.columns_[i];
      const auto number = number_in(fields[place_in_row]);
      if (!number) {
        mistakes_.add(location(record.line), fmt::format("{}: expected a number", column.name),
                      shown_value(fields[place_in_row]) + hint_on_number(fields[place_in_row]));
      }
      column.written.push_back(number.value_or(0.0));
      column.values.push_back(conversion(number.value_or(0.0)));
    }
  }

  /// A hint on the meaning of a text that is not a number.
  [[nodiscard]] std::string hint_on_number(std::string text) const {
    if (text.ends_with(" days, shown as a date or time")) {
      return " (write it in the unit of the column, as a number; a day has 86400 s)";
    }
    if (!table_.reading_.sheet.empty() && text.find(" stored, shown ") != std::string::npos) {
      return " (write the number that is meant, in a format that shows it as it is)";
    }
    const auto size = text.size();
    for (const std::string_view blank : {" ", "\u00a0", "\u202f", "'", "’"}) {
      for (auto at = text.find(blank); at != std::string::npos; at = text.find(blank)) text.erase(at, blank.size());
    }
    const bool has_blanks = text.size() < size;
    const auto points = std::ranges::count(text, '.'), commas = std::ranges::count(text, ',');
    std::erase_if(text, [](char letter) { return letter == '.' || letter == ','; });
    if (!detail::parse_number(text)) return "";
    if (has_blanks || points + commas > 1) return " (numbers are read without signs that part thousands)";
    if (layout_.separator != ',')
      return fmt::format(" (other numbers have decimal {}s)", commas == 1 ? "point" : "comma");
    return " (decimal commas are read where semicolons or tabs part the columns)";
  }

  [[nodiscard]] std::optional<double> number_in(const std::string& field) const {
    if (!layout_.has_decimal_commas) return detail::parse_number(field);
    auto with_point = field;
    std::ranges::replace(with_point, ',', '.');
    return detail::parse_number(with_point);
  }

  struct Source {
    std::size_t place_in_row;
    detail::Conversion conversion;
  };

  MeasuredTable table_;
  std::span<const ColumnChoice> choices_;
  FileMistakes mistakes_;
  detail::TableLayout layout_;
  std::vector<std::optional<detail::ColumnMeaning>> meanings_;  ///< meaning of each name
  std::vector<Source> sources_;                                 ///< source of each column of the table
  std::vector<std::pair<std::size_t, std::size_t>> twins_;      ///< indices of columns of one quantity and kind
  std::vector<std::size_t> label_columns_;                      ///< indices of the label columns in a row
  std::vector<std::string> first_labels_;                       ///< labels of the first row
};

MeasuredTable read_measured_table(const std::filesystem::path& path, std::span<const ColumnChoice> choices) {
  return MeasuredTableReader(path, choices).read();
}

}  // namespace breccia
