#include "deck/temperature_shift.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "breccia/tables/measured_table_reader.hpp"

#include "io/file_mistakes.hpp"
#include "viscoelasticity/reference_temperature.hpp"

namespace breccia {
namespace {

enum class LawName { wlf, arrhenius, table, measured };

/// Reads the keys of a law; returns nothing after a mistake.
std::optional<ShiftLaw> read_wlf(const Section& section) {
  const WilliamsLandelFerry law{
      section.number("c1", Range::positive()),
      section.quantity("c2", Dimension::temperature_difference, Range::positive()),
      section.quantity("reference", Dimension::temperature, Range::not_negative()),
  };
  return std::isnan(law.c1 + law.c2 + law.reference_temperature) ? std::nullopt : std::optional<ShiftLaw>(law);
}

/// Reads the keys of a law; returns nothing after a mistake.
std::optional<ShiftLaw> read_arrhenius(const Section& section) {
  const double energy = section.quantity("activation_energy", Dimension::molar_energy, Range::positive());
  const double reference = section.quantity("reference", Dimension::temperature, Range::positive());
  return std::isnan(energy + reference) ? std::nullopt : std::optional<ShiftLaw>(arrhenius(energy, reference));
}

/// A temperature [K] as text in degrees Celsius: "-41 degC".
std::string in_celsius(double temperature) {
  constexpr double zero_celsius = 273.15;
  return fmt::format("{:.6g} degC", temperature - zero_celsius);
}

/// log10 a_T of every row of a file that has either a_T or its logarithm. Throws InputError.
std::vector<double> log10_factors_of(const MeasuredTable& table) {
  // Where a file has both, the logarithm has more digits.
  if (!table.has({Quantity::shift_factor}) || table.has({Quantity::log10_shift_factor})) {
    table.require({Quantity::temperature, Quantity::log10_shift_factor});
    return table.column(Quantity::log10_shift_factor).values;
  }
  auto factors = table.column(Quantity::shift_factor).values;
  FileMistakes mistakes(table.path());
  for (std::size_t row = 0; row < factors.size(); ++row) {
    if (!(factors[row] > 0.0)) {
      mistakes.add(table.location(row), "expected a positive shift factor", fmt::format("{}", factors[row]));
    }
    factors[row] = std::log10(factors[row]);
  }
  mistakes.refuse();
  return factors;
}

/// A file of temperatures and shift factors, whose rows may be in any order. Throws InputError and FileError.
ShiftTable read_shift_file(const std::filesystem::path& path) {
  const auto table = read_measured_table(path);
  table.require({Quantity::temperature});
  const auto& temperatures = table.column(Quantity::temperature).values;
  const auto factors = log10_factors_of(table);
  std::vector<std::size_t> order(temperatures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t row) { return temperatures[row]; });
  FileMistakes mistakes(path);
  std::vector<double> sorted_temperatures, sorted_factors;
  for (const auto row : order) {
    const double temperature = temperatures[row], factor = factors[row];
    const bool is_first = sorted_factors.empty();
    if (!(temperature > 0.0) || !std::isfinite(temperature)) {
      mistakes.add(table.location(row), "expected a temperature above absolute zero", in_celsius(temperature));
    } else if (!(std::abs(factor) <= ShiftTable::most_decades)) {
      mistakes.add(table.location(row), "expected a shift factor between 1e-100 and 1e100",
                   fmt::format("10^{}", factor));
    } else if (!is_first && temperature == sorted_temperatures.back()) {
      mistakes.add(table.location(row), "expected each temperature once", in_celsius(temperature));
    } else if (!is_first && factor >= sorted_factors.back()) {
      mistakes.add(
          table.location(row), "expected factors that fall as the temperature rises",
          fmt::format("log10 a_T = {:g} at {} after {:g}", factor, in_celsius(temperature), sorted_factors.back()));
    }
    sorted_temperatures.push_back(temperature);
    sorted_factors.push_back(factor);
  }
  if (order.size() < 2) mistakes.add("", "expected at least two temperatures");
  mistakes.refuse();
  const double first = sorted_temperatures.front();
  return {std::move(sorted_temperatures), std::move(sorted_factors), first};
}

/// Reads the keys of a law; returns nothing after a mistake.
std::optional<ShiftLaw> read_table(const Section& section) {
  const auto path = section.file("table");
  const double reference = section.quantity("reference", Dimension::temperature, Range::positive());
  std::optional<ShiftLaw> law;
  if (path.empty() || std::isnan(reference)) return law;
  std::optional<ShiftTable> table;
  section.report_errors_of("table", [&] { table = read_shift_file(path); });
  if (table) section.report_errors_of("reference", [&] { law = with_reference(*table, reference); });
  return law;
}

double reference_temperature_of(const ShiftLaw& law) {
  const auto* table = std::get_if<ShiftTable>(&law);
  return table != nullptr ? table->reference_temperature() : std::get<WilliamsLandelFerry>(law).reference_temperature;
}

std::optional<ShiftLaw> read_law(const Section& section, const std::optional<ShiftLaw>& measured) {
  const auto name = section.choice<LawName>("law", {{"wlf", LawName::wlf},
                                                    {"arrhenius", LawName::arrhenius},
                                                    {"table", LawName::table},
                                                    {"measured", LawName::measured}});
  if (!name) {
    static_cast<void>(section.keys());  // the law decides which of the keys are allowed
    return std::nullopt;
  }
  switch (*name) {
    case LawName::wlf:
      return read_wlf(section);
    case LawName::arrhenius:
      return read_arrhenius(section);
    case LawName::measured:
      if (!measured) {
        section.report("law",
                       "expected one modulus of this material from measured data at several temperatures "
                       "({ measured = ... }), whose shift factors fall as the temperature rises");
      }
      return measured;
    case LawName::table:
      break;
  }
  return read_table(section);
}

}  // namespace

std::optional<TemperatureShift> read_temperature_shift(const Section& material,
                                                       const std::optional<ShiftLaw>& measured) {
  const auto section = material.optional_section("temperature_shift");
  if (!section && measured) return TemperatureShift{*measured, reference_temperature_of(*measured)};
  if (!section) return std::nullopt;
  const auto law = read_law(*section, measured);
  const double temperature = section->quantity("temperature", Dimension::temperature, Range::positive());
  std::optional<TemperatureShift> shift;
  if (!law || std::isnan(temperature)) return shift;
  section->report_errors_of("temperature", [&] {
    static_cast<void>(shift_factor(*law, temperature));
    shift = {*law, temperature};
  });
  return shift;
}

}  // namespace breccia
