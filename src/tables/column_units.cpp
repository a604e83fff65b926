#include "tables/column_units.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/units.hpp"

namespace breccia::detail {

namespace {

/// The conversion from a unit of the given size in SI units.
Conversion by_factor(double factor) {
  const double parts = std::round(1.0 / factor);
  constexpr double tolerance = 1e-12;
  if (factor < 1.0 && std::abs(parts * factor - 1.0) < tolerance) return {1.0, parts};
  return {factor};
}

Conversion reciprocal(const Conversion& conversion) {
  return {conversion.divisor, conversion.factor};
}

Conversion by_unit(std::string_view unit, Dimension dimension) {
  // UDUNITS-2 knows the dyne by its full name only.
  if (unit.starts_with("dyn/")) return by_unit(fmt::format("dyne{}", unit.substr(3)), dimension);
  return by_factor(parse_quantity(fmt::format("1 {}", unit), dimension));
}

/// The unit of the reciprocal: "Pa" for "1_per_Pa", "1/Pa", "/Pa", "Pa^-1" or "Pa-1".
Conversion reciprocal_pressure(std::string_view unit) {
  for (const std::string_view beginning : {"1_per_", "1/", "1 / ", "/"}) {
    if (unit.starts_with(beginning)) return reciprocal(by_unit(unit.substr(beginning.size()), Dimension::pressure));
  }
  for (const std::string_view ending : {"^-1", "-1", "⁻¹"}) {
    if (unit.ends_with(ending)) {
      return reciprocal(by_unit(unit.substr(0, unit.size() - ending.size()), Dimension::pressure));
    }
  }
  throw InputError(fmt::format("expected a unit such as 1_per_Pa, got \"{}\"", unit));
}

/// The conversion of a frequency to an angular frequency. The unit determines whether it counts cycles or radians. An
/// inverse time determines neither: it is accepted only if the name of the column is that of an angular frequency.
Conversion frequency(std::string_view unit, bool counts_cycles) {
  for (const auto& [prefix, size] : {std::pair{"mrad", 1e-3}, {"krad", 1e3}, {"Mrad", 1e6}}) {
    if (!unit.starts_with(prefix)) continue;
    const auto [factor, divisor, no_offset] = frequency(unit.substr(1), counts_cycles);
    return by_factor(size * factor / divisor);
  }
  for (const std::string_view angle : {"rad_per_", "rad/", "rad /"}) {
    if (unit.starts_with(angle)) return reciprocal(by_unit(unit.substr(angle.size()), Dimension::time));
  }
  for (const std::string_view rate : {"rad s-1", "rad s^-1", "rad·s-1", "rad*s^-1", "rad s⁻¹", "rad·s⁻¹"}) {
    if (unit == rate) return {};
  }
  constexpr double turn = 2.0 * std::numbers::pi, minute = 60.0;
  if (unit == "rpm") return {turn / minute};
  for (const std::string_view rate : {"cycles/s", "cycle/s", "cycles/sec", "cps"}) {
    if (unit == rate) return {turn};
  }
  if (counts_cycles) {
    if (is_in_hertz(unit)) return {turn * parse_quantity(fmt::format("1 {}", unit), Dimension::frequency)};
    const auto one = split_quantity(fmt::format("1 {}", unit));
    if (!one || !number_in_unit(*one, "s-1")) {
      static_cast<void>(parse_quantity(fmt::format("1 {}", unit), Dimension::frequency));
    }
    throw InputError(fmt::format("\"{}\" may mean cycles or radians; write Hz or rad/s", unit));
  }
  if (unit == "1/s" || unit == "s-1" || unit == "s^-1" || unit == "s⁻¹") return {};
  throw InputError(fmt::format("expected a unit such as rad_per_s, got \"{}\"", unit));
}

Conversion temperature_conversion(std::string_view unit) {
  // In UDUNITS-2 C is the coulomb and F the farad.
  if (unit == "C" || unit == "deg C" || unit == "deg. C" || unit == "ºC") unit = "degC";
  if (unit == "F" || unit == "deg F" || unit == "ºF") unit = "degF";
  return {parse_quantity(fmt::format("1 {}", unit), Dimension::temperature_difference), 1.0,
          parse_quantity(fmt::format("0 {}", unit), Dimension::temperature)};
}

Conversion fraction(std::string_view unit) {
  if (unit.empty() || unit == "-" || unit == "1") return {};
  if (unit == "%") return {1.0, 100.0};
  throw InputError(fmt::format("expected none, or %, got \"{}\"", unit));
}

Conversion number_without_unit(std::string_view unit) {
  if (unit.empty() || unit == "-" || unit == "1") return {};
  throw InputError(fmt::format("expected none, got \"{}\"", unit));
}

/// Whether a quantity has no unit.
bool is_number(Quantity quantity) {
  return quantity == Quantity::filler || quantity == Quantity::particle || quantity == Quantity::film_share ||
         quantity == Quantity::shift_factor || quantity == Quantity::log10_shift_factor ||
         quantity == Quantity::loss_tangent;
}

std::string_view example_of_unit(const ColumnMeaning& meaning) {
  switch (meaning.quantity) {
    case Quantity::time:
    case Quantity::relaxation_time:
      return "s";
    case Quantity::compliance:
      return "1/Pa";
    case Quantity::angular_frequency:
      return meaning.counts_cycles ? "Hz" : "rad/s";
    case Quantity::temperature:
      return "degC";
    case Quantity::diameter:
    case Quantity::x:
    case Quantity::y:
    case Quantity::z:
    case Quantity::axis_1:
    case Quantity::axis_2:
    case Quantity::axis_3:
      return "um";
    case Quantity::phase_angle:
    case Quantity::angle:
    case Quantity::azimuth:
    case Quantity::elevation:
    case Quantity::roll:
      return "deg";
    case Quantity::weight:
      return "m2";
    default:
      return "Pa";
  }
}

}  // namespace

double Conversion::operator()(double value) const {
  if (divisor != 1.0) return value / divisor;
  return offset == 0.0 ? factor * value : factor * value + offset;
}

Conversion conversion_of(const ColumnMeaning& meaning) {
  const std::string_view unit = meaning.unit;
  if (meaning.quantity == Quantity::cumulative_volume_fraction) return fraction(unit);
  if (is_number(meaning.quantity)) return number_without_unit(unit);
  if (unit.empty()) {
    throw InputError(
        fmt::format("expected one in the name of the column, as in \"[{}]\", got none", example_of_unit(meaning)));
  }
  switch (meaning.quantity) {
    case Quantity::time:
    case Quantity::relaxation_time:
      return by_unit(unit, Dimension::time);
    case Quantity::compliance:
      return reciprocal_pressure(unit);
    case Quantity::angular_frequency:
      return frequency(unit, meaning.counts_cycles);
    case Quantity::temperature:
      return temperature_conversion(unit);
    case Quantity::diameter:
    case Quantity::x:
    case Quantity::y:
    case Quantity::z:
    case Quantity::axis_1:
    case Quantity::axis_2:
    case Quantity::axis_3:
      return by_unit(unit, Dimension::length);
    case Quantity::phase_angle:
    case Quantity::angle:
    case Quantity::azimuth:
    case Quantity::elevation:
    case Quantity::roll:
      return by_unit(unit, Dimension::angle);
    case Quantity::weight:
      return by_unit(unit, Dimension::area);
    default:
      return by_unit(unit, Dimension::pressure);
  }
}

}  // namespace breccia::detail
