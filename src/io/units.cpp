#include "io/units.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <udunits2.h>

#include "breccia/error.hpp"

#include "io/nearest_name.hpp"
#include "io/trimmed.hpp"

namespace breccia {

namespace {

struct ReadableUnit {
  double size;  ///< size of the unit in the SI unit
  std::string_view symbol;
};

struct DimensionFacts {
  std::string_view name;
  std::string_view example;
  const char* si_unit;
  std::span<const ReadableUnit> readable;  ///< units for readable(), rising
  std::vector<std::string> common;         ///< common units, as suggestions for a misspelt one
};

constexpr std::array<ReadableUnit, 4> lengths{{{1e-9, "nm"}, {1e-6, "um"}, {1e-3, "mm"}, {1.0, "m"}}};
constexpr std::array<ReadableUnit, 5> times{{{1e-12, "ps"}, {1e-9, "ns"}, {1e-6, "us"}, {1e-3, "ms"}, {1.0, "s"}}};
constexpr std::array<ReadableUnit, 5> frequencies{
    {{1.0, "Hz"}, {1e3, "kHz"}, {1e6, "MHz"}, {1e9, "GHz"}, {1e12, "THz"}}};
constexpr std::array<ReadableUnit, 4> pressures{{{1.0, "Pa"}, {1e3, "kPa"}, {1e6, "MPa"}, {1e9, "GPa"}}};
constexpr std::array<ReadableUnit, 1> densities{{{1.0, "kg/m^3"}}};
constexpr std::array<ReadableUnit, 1> temperatures{{{1.0, "K"}}};
constexpr std::array<ReadableUnit, 3> areas{{{1e-12, "um^2"}, {1e-6, "mm^2"}, {1.0, "m^2"}}};
constexpr std::array<ReadableUnit, 1> angles{{{std::numbers::pi / 180.0, "deg"}}};
constexpr std::array<ReadableUnit, 2> molar_energies{{{1.0, "J/mol"}, {1e3, "kJ/mol"}}};
constexpr std::array<ReadableUnit, 3> inverse_lengths{{{1.0, "1/m"}, {1e3, "1/mm"}, {1e6, "1/um"}}};

constexpr std::array<ReadableUnit, 3> interface_stiffnesses{{{1e9, "MPa/mm"}, {1e12, "MPa/um"}, {1e15, "GPa/um"}}};

constexpr std::array<ReadableUnit, 4> compliances{{{1e-12, "1/TPa"}, {1e-9, "1/GPa"}, {1e-6, "1/MPa"}, {1.0, "1/Pa"}}};

constexpr std::array<ReadableUnit, 1> expansions{{{1.0, "1/K"}}};

const DimensionFacts& facts(Dimension dimension) {
  static const std::array<DimensionFacts, 14> all{{
      {"length", "48 um", "m", lengths, {"nm", "um", "mm", "cm", "m", "km"}},
      {"time", "10 ns", "s", times, {"ps", "ns", "us", "ms", "s", "min", "hour", "day"}},
      {"frequency", "1 kHz", "s-1", frequencies, {"Hz", "kHz", "MHz", "GHz"}},
      {"pressure", "3.6 GPa", "Pa", pressures, {"Pa", "kPa", "MPa", "GPa", "bar", "psi", "N/mm^2"}},
      {"density", "1.48 g/cm^3", "kg m-3", densities, {"kg/m^3", "g/cm^3"}},
      {"temperature", "19 degC", "K", temperatures, {"degC", "K", "degF"}},
      {"temperature difference", "120 K", "K", temperatures, {"K", "degC", "degF"}},
      {"reciprocal length", "12500 /mm", "m-1", inverse_lengths, {"1/m", "1/mm", "1/um"}},
      {"area", "2 mm^2", "m2", areas, {"um^2", "mm^2", "m^2"}},
      {"angle", "30 deg", "rad", angles, {"deg", "rad"}},
      {"molar energy", "120 kJ/mol", "J mol-1", molar_energies, {"J/mol", "kJ/mol", "kcal/mol"}},
      {"stiffness of an interface",
       "1 GPa/um",
       "Pa m-1",
       interface_stiffnesses,
       {"Pa/m", "MPa/mm", "GPa/mm", "MPa/um", "GPa/um"}},
      {"compliance", "0.04 /GPa", "Pa-1", compliances, {"1/Pa", "1/MPa", "1/GPa", "1/TPa"}},
      {"thermal expansion", "12e-6 /K", "K-1", expansions, {"1/K"}},
  }};
  return all[static_cast<std::size_t>(dimension)];
}

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

/// UDUNITS-2 has global state: hold this lock while calling it.
std::mutex udunits_mutex;

ut_system* unit_system() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    ut_system* loaded = ut_read_xml(nullptr);
    if (loaded == nullptr)
      throw FileError("cannot read the unit database of UDUNITS-2 (is libudunits2-data installed?)");
    return loaded;
  }();
  return system;
}

Unit parse_unit(const std::string& text) {
  return Unit(ut_parse(unit_system(), text.c_str(), UT_UTF8));
}

/// The converter to an SI unit, if the unit has the same dimension. UDUNITS-2 alone would also turn s into 1/s.
Converter converter_to(const Unit& unit, const Unit& si_unit) {
  if (!unit) return nullptr;
  const Unit ratio(ut_divide(unit.get(), si_unit.get()));
  if (!ratio || ut_is_dimensionless(ratio.get()) == 0) return nullptr;
  return Converter(ut_get_converter(unit.get(), si_unit.get()));
}

std::optional<double> convert(const NumberAndUnit& quantity, const std::string& unit) {
  const std::lock_guard lock(udunits_mutex);
  const auto from = parse_unit(quantity.unit), to = parse_unit(unit);
  const auto converter = to ? converter_to(from, to) : nullptr;
  return converter ? std::optional(cv_convert_double(converter.get(), quantity.number)) : std::nullopt;
}

bool are_equal_but_for_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char one, unsigned char other) { return std::tolower(one) == std::tolower(other); });
}

/// The end of a message about a text that is not a quantity of the dimension: a suggestion of the text that was meant.
std::string hint(const NumberAndUnit& quantity, Dimension dimension) {
  const auto& unit = quantity.unit;
  constexpr std::string_view digits = "0123456789";
  if (unit.size() > 1 && unit[0] == ',' && digits.find(unit[1]) != std::string_view::npos) {
    return ": expected a decimal point, got a comma";
  }
  const auto& common = facts(dimension).common;
  std::optional<std::string> meant;
  const bool is_temperature = dimension == Dimension::temperature || dimension == Dimension::temperature_difference;
  if (is_temperature && (unit == "C" || unit == "F")) {
    meant = "deg" + unit;  // UDUNITS-2 reads C and F as coulomb and farad
  } else {
    const auto same = std::ranges::find_if(common, [&](const auto& one) { return are_equal_but_for_case(one, unit); });
    constexpr std::size_t fewest_letters = 3;  // shorter names are too similar to each other
    if (same != common.end()) {
      meant = *same;
    } else if (unit.size() >= fewest_letters) {
      meant = nearest_name(unit, common);
    }
  }
  return meant && *meant != unit ? fmt::format(", did you mean \"{}\"?", *meant) : "";
}

/// A converted value without the rounding error of the conversion: "1 g/cm^3" is 1000 kg/m^3, not 999.9999999999999.
double as_written(double converted) {
  const auto digits = fmt::format("{:.15g}", converted);
  double value = converted;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

bool contains_one_of(std::string_view text, std::initializer_list<std::string_view> parts) {
  return std::ranges::any_of(parts, [&](auto part) { return text.find(part) != std::string_view::npos; });
}

/// UDUNITS-2 takes a radian for the number 1, and rad/s for Hz.
bool is_angle_per_time(std::string_view unit) {
  return contains_one_of(unit, {"rad", "deg", "arc", "°", "'", "\""});
}

/// UDUNITS-2 takes a turn for the number 2 pi, and rpm for 0.105 Hz.
bool counts_turns(std::string_view unit) {
  return contains_one_of(unit, {"rpm", "rps", "cps", "cycle", "circle", "revolution", "rotation", "turn"});
}

/// The quantity in the SI unit of the dimension, or the reason why it has none (empty for another dimension).
std::variant<double, std::string> to_si(const NumberAndUnit& quantity, Dimension dimension) {
  const std::lock_guard lock(udunits_mutex);
  const bool is_angle = dimension == Dimension::angle;
  const auto unit = parse_unit(is_angle && quantity.unit == "deg" ? "degree" : quantity.unit);
  if (!unit && quantity.unit.starts_with(',')) return hint(quantity, dimension);
  if (!unit) return fmt::format(": unknown unit \"{}\"{}", quantity.unit, hint(quantity, dimension));
  const auto converter = converter_to(unit, parse_unit(facts(dimension).si_unit));
  if (!converter) return hint(quantity, dimension);
  const bool is_difference = dimension == Dimension::temperature_difference;
  const double origin = is_difference ? cv_convert_double(converter.get(), 0.0) : 0.0;
  const double converted = cv_convert_double(converter.get(), quantity.number) - origin;
  if (dimension == Dimension::frequency && !is_in_hertz(quantity.unit)) {
    if (counts_turns(quantity.unit) || is_angle_per_time(quantity.unit)) {
      return as_written(converted / (2.0 * std::numbers::pi));
    }
    return ": it may mean cycles or radians, 1 Hz is 6.2832 rad/s; expected Hz or rad/s";
  }
  // A degree is no decimal fraction of a radian.
  return is_angle ? converted : as_written(converted);
}

}  // namespace

bool is_in_hertz(std::string_view unit) {
  return unit.ends_with("Hz") || unit.ends_with("hertz") || unit.ends_with("Hertz");
}

std::string_view name(Dimension dimension) {
  return facts(dimension).name;
}

std::string with_article(Dimension dimension) {
  const auto noun = name(dimension);
  return fmt::format("{} {}", noun.starts_with('a') ? "an" : "a", noun);
}

std::string_view si_unit(Dimension dimension) {
  return facts(dimension).si_unit;
}

std::string_view example(Dimension dimension) {
  return facts(dimension).example;
}

std::optional<NumberAndUnit> split_quantity(std::string_view text) {
  text = detail::trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  text = detail::trimmed(text);
  if (text.starts_with('/')) return NumberAndUnit{number, fmt::format("1{}", text)};
  if (text.find_first_of("0123456789+-.") == 0 && !text.starts_with("1/")) return std::nullopt;
  return NumberAndUnit{number, std::string(text)};
}

std::optional<double> number_in_unit(const NumberAndUnit& quantity, const std::string& unit) {
  if (quantity.unit == unit) return quantity.number;
  const auto number = convert(quantity, unit);
  return number && std::isfinite(*number) ? std::optional(as_written(*number)) : std::nullopt;
}

double parse_quantity(std::string_view text, Dimension dimension) {
  const auto quantity = split_quantity(text);
  if (!quantity) {
    throw InputError(fmt::format(R"(expected {}, a number and its unit such as "{}", got "{}")",
                                 with_article(dimension), example(dimension), text));
  }
  if (quantity->unit.empty()) {
    throw InputError(fmt::format(R"(expected {} with its unit, such as "{}", got "{}")", with_article(dimension),
                                 example(dimension), text));
  }
  const auto value = to_si(*quantity, dimension);
  if (const auto* si = std::get_if<double>(&value); si != nullptr && std::isfinite(*si)) return *si;
  const auto* reason = std::get_if<std::string>(&value);
  throw InputError(fmt::format("expected {}, got \"{}\"{}", with_article(dimension), text,
                               reason != nullptr ? *reason : std::string()));
}

std::string readable(double value, Dimension dimension) {
  const auto units = facts(dimension).readable;
  auto unit = units.front();
  for (const auto& larger : units) {
    const bool suits = value == 0.0 ? larger.size <= 1.0 : std::abs(value) >= larger.size * (1.0 - 1e-9);
    if (suits) unit = larger;
  }
  return fmt::format("{:.6g} {}", value / unit.size, unit.symbol);
}

}  // namespace breccia
