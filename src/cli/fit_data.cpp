#include "fit_data.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/io/csv.hpp"
#include "breccia/study/prony_file.hpp"

#include "fit_columns.hpp"

namespace breccia::cli {
namespace {

using Columns = std::map<Quantity, MeasuredColumn>;

bool has(const Columns& columns, std::initializer_list<Quantity> quantities) {
  return std::ranges::all_of(quantities, [&](Quantity quantity) { return columns.contains(quantity); });
}

[[noreturn]] void throw_mistakes(std::vector<std::string> mistakes, const std::string& file) {
  constexpr std::size_t most_shown = 20;
  if (mistakes.size() > most_shown) {
    const auto more = mistakes.size() - most_shown;
    mistakes.resize(most_shown);
    mistakes.push_back(fmt::format("{}: {} more", file, more));
  }
  throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
}

/// Measured quantities have logarithms: each must be positive, and finite.
void require_positive(const CsvTable& table, const Columns& columns, const std::vector<Quantity>& quantities) {
  const auto file = table.path().string();
  std::vector<std::string> mistakes;
  constexpr std::size_t fewest = 3;
  if (table.rows() < fewest) {
    mistakes.push_back(fmt::format("{}: expected at least {} rows, got {}", file, fewest, table.rows()));
  }
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const auto quantity : quantities) {
      const auto& column = columns.at(quantity);
      if (column.values[row] > 0.0 && std::isfinite(column.values[row])) continue;
      mistakes.push_back(
          fmt::format("{}: {}: expected {}, got {}", table.place(row), column.name,
                      quantity == Quantity::temperature ? "a temperature above absolute zero" : "a positive number",
                      table.numbers(column.name)[row]));
    }
  }
  if (!mistakes.empty()) throw_mistakes(std::move(mistakes), file);
}

/// The rows in an order by which a column rises.
std::vector<std::size_t> rising_rows(const std::vector<double>& column) {
  std::vector<std::size_t> rows(column.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return column[row]; });
  return rows;
}

std::vector<double> in_order(const std::vector<double>& column, const std::vector<std::size_t>& rows) {
  std::vector<double> values(rows.size());
  std::ranges::transform(rows, values.begin(), [&](std::size_t row) { return column[row]; });
  return values;
}

/// Rows of one temperature, for which the chamber's scatter of some tenths of a kelvin counts as none.
std::vector<std::vector<std::size_t>> rows_by_temperature(const std::vector<double>& temperatures) {
  constexpr double scatter = 0.5;
  std::vector<std::vector<std::size_t>> groups;
  for (const auto row : rising_rows(temperatures)) {
    const bool is_new = groups.empty() || temperatures[row] - temperatures[groups.back().back()] > scatter;
    if (is_new) groups.emplace_back();
    groups.back().push_back(row);
  }
  return groups;
}

DynamicData dynamic_data(const CsvTable& table, const Columns& columns) {
  const auto& frequencies = columns.at(Quantity::angular_frequency);
  const auto& storage = columns.at(Quantity::storage_modulus).values;
  const auto& loss = columns.at(Quantity::loss_modulus).values;
  const auto found = columns.find(Quantity::temperature);
  const auto temperatures =
      found == columns.end() ? std::vector<double>(table.rows(), 0.0) : std::vector<double>(found->second.values);
  DynamicData data;
  std::vector<std::string> mistakes;
  for (auto& rows : rows_by_temperature(temperatures)) {
    std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return frequencies.values[row]; });
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (frequencies.values[rows[i]] > frequencies.values[rows[i - 1]]) continue;
      mistakes.push_back(fmt::format("{}: {}: {} stands already at {}, at the same temperature", table.place(rows[i]),
                                     frequencies.name, table.numbers(frequencies.name)[rows[i]],
                                     table.place(rows[i - 1])));
    }
    const auto of_sweep = in_order(temperatures, rows);
    const double mean = std::reduce(of_sweep.begin(), of_sweep.end()) / static_cast<double>(of_sweep.size());
    data.sweeps.push_back({mean, in_order(frequencies.values, rows), in_order(storage, rows), in_order(loss, rows)});
  }
  if (!mistakes.empty()) throw_mistakes(std::move(mistakes), table.path().string());
  return data;
}

}  // namespace

FitData read_fit_data(const std::filesystem::path& path) {
  using enum Quantity;
  const auto table = read_csv(path);
  const auto columns = measured_columns(table);
  if (has(columns, {relaxation_time, modulus})) {
    const auto file = read_prony_file(path);
    if (file.terms.empty()) {
      throw InputError(fmt::format("{}: a Prony series without a term has nothing to convert", path.string()));
    }
    return PronySeries(file.equilibrium.value_or(0.0), file.terms);
  }
  if (has(columns, {angular_frequency, storage_modulus, loss_modulus})) {
    std::vector quantities = {angular_frequency, storage_modulus, loss_modulus};
    if (has(columns, {temperature})) quantities.push_back(temperature);
    require_positive(table, columns, quantities);
    return dynamic_data(table, columns);
  }
  const bool is_relaxation = has(columns, {time, modulus}), is_creep = has(columns, {time, compliance});
  if (is_relaxation != is_creep) {
    const auto value = is_relaxation ? modulus : compliance;
    require_positive(table, columns, {time, value});
    const auto rows = rising_rows(columns.at(time).values);
    auto times = in_order(columns.at(time).values, rows), values = in_order(columns.at(value).values, rows);
    if (is_relaxation) return RelaxationData{std::move(times), std::move(values)};
    return CreepData{std::move(times), std::move(values)};
  }
  throw InputError(fmt::format(
      "{}: expected the columns of one of\n"
      "  a relaxation modulus  time_s, modulus_Pa\n"
      "  a creep compliance    time_s, compliance_1_per_Pa\n"
      "  dynamic moduli        frequency_Hz or angular_frequency_rad_per_s, storage_modulus_Pa, loss_modulus_Pa and,\n"
      "                        for a master curve, temperature_K or temperature_degC\n"
      "with any unit at the end of a name, or\n"
      "  a Prony series        relaxation_time_s, modulus_Pa\n"
      "; it has \"{}\"",
      path.string(), fmt::join(table.names(), "\", \"")));
}

}  // namespace breccia::cli
