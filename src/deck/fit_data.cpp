#include "breccia/deck/fit_data.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

#include "breccia/deck/prony_file.hpp"
#include "breccia/error.hpp"
#include "breccia/io/complex_modulus.hpp"
#include "breccia/io/file_mistakes.hpp"

namespace breccia {
namespace {

/// What is expected of a number in a column.
std::string_view expected_in(const MeasuredColumn& column) {
  if (column.quantity == Quantity::temperature) return "a temperature above absolute zero";
  return column.quantity == Quantity::phase_angle ? "an angle above 0 and below 90 degrees" : "a positive number";
}

/// Reports values that are not positive and finite, since the fits use their logarithms, and phase angles that no solid
/// has.
void require_positive(const MeasuredTable& table, const std::vector<const MeasuredColumn*>& columns) {
  FileMistakes mistakes(table.path());
  constexpr std::size_t fewest = 3;
  if (table.rows() < fewest) {
    mistakes.add("", fmt::format("expected at least {} rows", fewest), fmt::format("{}", table.rows()));
  }
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const auto* column : columns) {
      const double value = column->values[row];
      const bool is_below =
          column->quantity == Quantity::phase_angle ? value < std::numbers::pi / 2 : std::isfinite(value);
      if (value > 0.0 && is_below) continue;
      mistakes.add(table.place(row), fmt::format("{}: expected {}", column->name, expected_in(*column)),
                   fmt::format("{}", column->written[row]));
    }
  }
  mistakes.refuse();
}

/// The indices of the rows, sorted by rising values of a column.
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

/// Groups rows of the same temperature, apart from scatter of some tenths of a kelvin in the test chamber.
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

/// Reports frequencies that occur more than once at a temperature.
void refuse_repeated(const MeasuredTable& table, const MeasuredColumn& frequencies,
                     const std::vector<std::vector<std::size_t>>& sweeps) {
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

DynamicData dynamic_data(const MeasuredTable& table, const ComplexModulusColumns& pair, ModulusKind kind) {
  using enum Quantity;
  table.refuse_unknown_units({temperature});
  const auto& frequencies = table.column(angular_frequency);
  const auto& second = pair.other == loss_modulus ? table.column(loss_modulus, kind) : table.column(pair.other);
  std::vector columns = {&frequencies, &table.column(pair.modulus, kind), &second};
  if (table.has({temperature})) columns.push_back(&table.column(temperature));
  require_positive(table, columns);
  const auto temperatures =
      table.has({temperature}) ? table.column(temperature).values : std::vector<double>(table.rows(), 0.0);
  auto sweeps = rows_by_temperature(temperatures);
  for (auto& rows : sweeps) {
    std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return frequencies.values[row]; });
  }
  refuse_repeated(table, frequencies, sweeps);
  const auto measured = complex_modulus(table, pair, kind);
  DynamicData data;
  for (const auto& rows : sweeps) {
    const auto of_sweep = in_order(temperatures, rows);
    const double mean = std::reduce(of_sweep.begin(), of_sweep.end()) / static_cast<double>(of_sweep.size());
    data.sweeps.push_back(
        {mean, in_order(frequencies.values, rows), in_order(measured.storage, rows), in_order(measured.loss, rows)});
  }
  return data;
}

PronySeries series(const std::filesystem::path& path, ModulusKind kind) {
  const auto file = read_prony_file(path, kind);
  if (file.terms.empty()) {
    throw InputError(fmt::format("{}: a Prony series without a term has nothing to convert", path.string()));
  }
  return {file.equilibrium.value_or(0.0), file.terms};
}

/// The kind of the moduli in a file; the names of the columns may give one kind, several or none.
ModulusKind kind_of(const MeasuredTable& table, ModulusKind given) {
  auto measured = table.kinds();
  std::erase(measured, ModulusKind::unspecified);
  if (given != ModulusKind::unspecified) return given;  // a column of another kind is refused when it is read
  if (measured.empty()) return ModulusKind::unspecified;
  if (measured.size() == 1 && measured.front() != ModulusKind::other) return measured.front();
  throw InputError(
      fmt::format("{}: expected one modulus, of shear, Young's or of bulk, got {}: of several one has to be "
                  "chosen; one that is none of these is fitted when its column is called modulus_Pa",
                  table.path().string(), table.list_of_names()));
}

[[noreturn]] void refuse_columns(const MeasuredTable& table) {
  using enum Quantity;
  table.refuse_unknown_units({time, relaxation_time, modulus, compliance, storage_modulus, loss_modulus,
                              absolute_modulus, phase_angle, loss_tangent, angular_frequency, temperature});
  throw InputError(fmt::format(
      "{}: expected the columns of one of\n"
      "  a relaxation modulus  time_s, modulus_Pa\n"
      "  a creep compliance    time_s, compliance_1_per_Pa\n"
      "  dynamic moduli        frequency_Hz or angular_frequency_rad_per_s, storage_modulus_Pa, loss_modulus_Pa and,\n"
      "                        for a master curve, temperature_K or temperature_degC; phase_angle_deg or tan_delta\n"
      "                        may stand for one of the moduli, \"|G*| [Pa]\" for the other\n"
      "  a Prony series        relaxation_time_s, modulus_Pa\n"
      "with any unit at the end of a name, or in brackets as in \"Storage modulus [MPa]\"; it has {}\n"
      "breccia fit --columns tells which column is which, as in --columns storage=NAME --columns loss=NAME",
      table.path().string(), table.list_of_names()));
}

/// Refuses tables of results with the curves of several tests, one below the other, since a fit takes one curve. In the
/// table of a sweep these may differ only in the values of swept keys; then each time occurs several times.
void refuse_several_curves(const MeasuredTable& table, std::vector<double> times) {
  table.refuse_several_series();
  const bool is_of_results = table.list_of_names().find("\"stage\"") != std::string::npos;
  std::ranges::sort(times);
  if (!is_of_results || std::ranges::adjacent_find(times) == times.end()) return;
  throw InputError(fmt::format(
      "{}: results with several curves, of stages, loads, boundaries or tasks; keep the rows of one of them",
      table.path().string()));
}

}  // namespace

FitInput fit_data_in(const MeasuredTable& table, ModulusKind given) {
  using enum Quantity;
  const auto kind = kind_of(table, given);
  if (table.has({relaxation_time, modulus})) return {series(table.path(), kind), kind};
  const auto pair = complex_modulus_columns(table);
  if (pair && table.has({angular_frequency})) return {dynamic_data(table, *pair, kind), kind};
  const bool is_relaxation = table.has({time, modulus}), is_creep = table.has({time, compliance});
  if (is_relaxation == is_creep) refuse_columns(table);
  const auto& times = table.column(time);
  const auto& values = table.column(is_relaxation ? modulus : compliance, kind);
  require_positive(table, {&times, &values});
  refuse_several_curves(table, times.values);
  const auto rows = rising_rows(times.values);
  if (is_relaxation) return {RelaxationData{in_order(times.values, rows), in_order(values.values, rows)}, kind};
  return {CreepData{in_order(times.values, rows), in_order(values.values, rows)}, kind};
}

}  // namespace breccia
