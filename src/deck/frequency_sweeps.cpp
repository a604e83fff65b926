#include "deck/frequency_sweeps.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "deck/measured_rows.hpp"
#include "deck/temperature_ramp.hpp"
#include "io/file_mistakes.hpp"

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
      mistakes.add(table.location(rows[i]),
                   fmt::format("{}: expected each frequency once at a temperature", frequencies.name),
                   fmt::format("{}, as at {}", frequencies.written[rows[i]], table.location(rows[i - 1])));
    }
  }
  mistakes.refuse();
}

/// Whether the temperature changed steadily through the measurement: most rows are in groups that span kelvins, or in
/// groups of one or two rows whose distance to the next group is a few kelvins at most.
bool is_ramp(const std::vector<double>& temperatures, const std::vector<Rows>& groups) {
  constexpr double kelvins = 2.0;
  constexpr std::size_t few = 2;
  std::size_t in_ramp = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto& rows = groups[i];
    const auto gap = [&](std::size_t lower) {
      return temperatures[groups[lower + 1].front()] - temperatures[groups[lower].back()];
    };
    const bool spans = temperatures[rows.back()] - temperatures[rows.front()] > kelvins;
    const bool is_near = (i > 0 && gap(i - 1) <= kelvins) || (i + 1 < groups.size() && gap(i) <= kelvins);
    if (spans || (rows.size() <= few && is_near)) in_ramp += rows.size();
  }
  return 2 * in_ramp > temperatures.size();
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
