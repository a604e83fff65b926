#include "deck/fit_data.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "deck/frequency_sweeps.hpp"
#include "deck/measured_rows.hpp"
#include "deck/prony_file.hpp"
#include "io/file_mistakes.hpp"
#include "tables/complex_modulus.hpp"
#include "tables/unknown_columns.hpp"

namespace breccia {
namespace {

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
  throw UnknownColumns(fmt::format(
      "{}: expected the columns of one of\n"
      "  a relaxation modulus  time_s, modulus_Pa\n"
      "  a creep compliance    time_s, compliance_1_per_Pa\n"
      "  dynamic moduli        frequency_Hz or angular_frequency_rad_per_s, storage_modulus_Pa, loss_modulus_Pa and,\n"
      "                        for a master curve, temperature_K or temperature_degC; phase_angle_deg or tan_delta\n"
      "                        may stand for one of the moduli, \"|G*| [Pa]\" for the other\n"
      "  a Prony series        relaxation_time_s, modulus_Pa\n"
      "with any unit at the end of a name, or in brackets as in \"Storage modulus [MPa]\"; it has {}",
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

/// Refuses several tables, one below the other, where one curve is expected.
void refuse_several_tables(const MeasuredTable& table) {
  if (table.reading().tables == 1) return;
  throw InputError(
      fmt::format("{}: {} tables, one below the other: only dynamic moduli with a column of temperatures "
                  "may have several; keep one of them",
                  table.path().string(), table.reading().tables));
}

/// Throws InputError where a table has fewer rows than a fit needs.
void require_rows(const MeasuredTable& table) {
  constexpr std::size_t fewest = 3;
  FileMistakes mistakes(table.path());
  if (table.rows() < fewest) {
    mistakes.add("", fmt::format("expected at least {} rows", fewest), fmt::format("{}", table.rows()));
  }
  mistakes.refuse();
}

}  // namespace

FitInput fit_data_in(const MeasuredTable& table, ModulusKind given) {
  auto input = measured_data_in(table, given);
  if (!std::holds_alternative<PronySeries>(input.data)) require_rows(table);
  return input;
}

FitInput measured_data_in(const MeasuredTable& table, ModulusKind given) {
  using enum Quantity;
  const auto kind = kind_of(table, given);
  const auto pair = complex_modulus_columns(table);
  const bool is_dynamic = pair && table.has({angular_frequency});
  if (!is_dynamic || !table.has({temperature})) refuse_several_tables(table);
  if (table.has({relaxation_time, modulus})) return {series(table.path(), kind), kind};
  if (is_dynamic) return {frequency_sweeps(table, *pair, kind), kind};
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
