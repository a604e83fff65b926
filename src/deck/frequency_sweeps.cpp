#include "frequency_sweeps.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/io/file_mistakes.hpp"

#include "measured_rows.hpp"
#include "temperature_ramp.hpp"

namespace breccia {
namespace {

using Rows = std::vector<std::size_t>;

/// Groups rows of the same temperature, apart from scatter of some tenths of a kelvin in the test chamber.
std::vector<Rows> rows_by_temperature(const std::vector<double>& temperatures) {
  constexpr double scatter = 0.5;
  std::vector<Rows> groups;
  for (const auto row : rising_rows(temperatures)) {
    const bool is_new = groups.empty() || temperatures[row] - temperatures[groups.back().back()] > scatter;
    if (is_new) groups.emplace_back();
    groups.back().push_back(row);
  }
  return groups;
}

/// Reports frequencies that occur more than once at a temperature.
void refuse_repeated(const MeasuredTable& table, const MeasuredColumn& frequencies, const std::vector<Rows>& sweeps) {
  FileMistakes mistakes(table.path());
  for (const auto& rows : sweeps) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (frequencies.values[rows[i]] > frequencies.values[rows[i - 1]]) continue;
      mistakes.add(table.place(rows[i]),
                   fmt::format("{}: expected each frequency once at a temperature", frequencies.name),
                   fmt::format("{}, as at {}", frequencies.written[rows[i]], table.place(rows[i - 1])));
    }
  }
  mistakes.refuse();
}

/// Whether the temperature rose through the measurement: sweeps would span kelvins, or all have one row.
bool is_ramp(const std::vector<double>& temperatures, const std::vector<Rows>& sweeps) {
  constexpr double longest = 2.0;
  constexpr std::size_t fewest = 3;
  return std::ranges::any_of(
             sweeps,
             [&](const Rows& rows) { return temperatures[rows.back()] - temperatures[rows.front()] > longest; }) ||
         (sweeps.size() >= fewest && std::ranges::all_of(sweeps, [](const Rows& rows) { return rows.size() == 1; }));
}

}  // namespace

DynamicData frequency_sweeps(const MeasuredTable& table, const ComplexModulusColumns& columns, ModulusKind kind) {
  using enum Quantity;
  table.refuse_unknown_units({temperature});
  const auto& frequencies = table.column(angular_frequency);
  const auto& second = columns.other == loss_modulus ? table.column(loss_modulus, kind) : table.column(columns.other);
  std::vector needed = {&frequencies, &table.column(columns.modulus, kind), &second};
  if (table.has({temperature})) needed.push_back(&table.column(temperature));
  require_positive(table, needed);
  const auto temperatures =
      table.has({temperature}) ? table.column(temperature).values : std::vector<double>(table.rows(), 0.0);
  const auto [storage, loss] = complex_modulus(table, columns, kind);
  auto sweeps = rows_by_temperature(temperatures);
  if (is_ramp(temperatures, sweeps))
    return sweeps_of_ramp(table.path(), temperatures, frequencies.values, storage, loss);
  for (auto& rows : sweeps) {
    std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return frequencies.values[row]; });
  }
  refuse_repeated(table, frequencies, sweeps);
  DynamicData data;
  for (const auto& rows : sweeps) {
    const auto of_sweep = in_order(temperatures, rows);
    const double mean = std::reduce(of_sweep.begin(), of_sweep.end()) / static_cast<double>(of_sweep.size());
    data.sweeps.push_back({mean, in_order(frequencies.values, rows), in_order(storage, rows), in_order(loss, rows)});
  }
  return data;
}

}  // namespace breccia
