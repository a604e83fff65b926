#include "fit_columns.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/io/units.hpp"

namespace breccia::cli {
namespace {

/// SI value = factor * value + offset.
struct Conversion {
  double factor = 1.0, offset = 0.0;
};

Conversion unit_of(std::string_view unit, Dimension dimension) {
  return {parse_quantity(fmt::format("1 {}", unit), dimension)};
}

Conversion time(std::string_view unit) {
  return unit_of(unit, Dimension::time);
}

Conversion pressure(std::string_view unit) {
  return unit_of(unit, Dimension::pressure);
}

Conversion reciprocal_pressure(std::string_view unit) {
  constexpr std::string_view reciprocal = "1_per_";
  if (unit.starts_with(reciprocal)) return {1.0 / pressure(unit.substr(reciprocal.size())).factor};
  throw InputError(fmt::format("expected a unit such as 1_per_Pa, got \"{}\"", unit));
}

Conversion cycles(std::string_view unit) {
  return {2.0 * std::numbers::pi * unit_of(unit, Dimension::frequency).factor};
}

Conversion radians(std::string_view unit) {
  constexpr std::string_view angle = "rad_per_";
  if (unit.starts_with(angle)) return {1.0 / time(unit.substr(angle.size())).factor};
  throw InputError(fmt::format("expected a unit such as rad_per_s, got \"{}\"", unit));
}

Conversion temperature(std::string_view unit) {
  return {unit_of(unit, Dimension::temperature_difference).factor,
          parse_quantity(fmt::format("0 {}", unit), Dimension::temperature)};
}

struct KnownColumn {
  std::string_view name;
  bool may_have_prefix;  ///< as in shear_modulus_Pa
  Quantity quantity;
  Conversion (*conversion)(std::string_view unit);
};

/// The longer of two names that end alike comes first.
constexpr std::array<KnownColumn, 9> known_columns{{
    {"relaxation_time_", false, Quantity::relaxation_time, time},
    {"time_", false, Quantity::time, time},
    {"storage_modulus_", true, Quantity::storage_modulus, pressure},
    {"loss_modulus_", true, Quantity::loss_modulus, pressure},
    {"modulus_", true, Quantity::modulus, pressure},
    {"compliance_", true, Quantity::compliance, reciprocal_pressure},
    {"angular_frequency_", false, Quantity::angular_frequency, radians},
    {"frequency_", false, Quantity::angular_frequency, cycles},
    {"temperature_", false, Quantity::temperature, temperature},
}};

struct Recognised {
  const KnownColumn* column;
  std::string_view unit;
};

std::optional<Recognised> recognise(std::string_view name) {
  for (const auto& known : known_columns) {
    const auto at = known.may_have_prefix ? name.find(known.name) : name.starts_with(known.name) ? 0 : name.npos;
    const bool is_word = at == 0 || (at != name.npos && name[at - 1] == '_');
    if (is_word) return Recognised{&known, name.substr(at + known.name.size())};
  }
  return std::nullopt;
}

}  // namespace

std::map<Quantity, MeasuredColumn> measured_columns(const CsvTable& table) {
  std::map<Quantity, MeasuredColumn> columns;
  std::vector<std::string> mistakes;
  for (const auto& name : table.names()) {
    const auto recognised = recognise(name);
    if (!recognised) continue;
    try {
      const auto [factor, offset] = recognised->column->conversion(recognised->unit);
      MeasuredColumn column{name, table.numbers(name)};
      for (double& value : column.values) value = factor * value + offset;
      const auto [earlier, is_new] = columns.emplace(recognised->column->quantity, std::move(column));
      if (!is_new) mistakes.push_back(fmt::format(R"("{}" says the same as "{}")", name, earlier->second.name));
    } catch (const InputError& error) {
      mistakes.push_back(fmt::format("the unit of \"{}\": {}", name, error.what()));
    }
  }
  for (auto& mistake : mistakes) mistake = fmt::format("{}: {}", table.path().string(), mistake);
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
  return columns;
}

}  // namespace breccia::cli
