#include "io/display.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

namespace breccia {
namespace {

struct Prefix {
  std::string_view name;
  double scale;
};
constexpr std::array<Prefix, 10> prefixes{{{"T", 1e12},
                                           {"G", 1e9},
                                           {"M", 1e6},
                                           {"k", 1e3},
                                           {"", 1.0},
                                           {"m", 1e-3},
                                           {"u", 1e-6},
                                           {"n", 1e-9},
                                           {"p", 1e-12},
                                           {"f", 1e-15}}};

double rounded(double value, int digits) {
  // Unlike std::stod() this function takes numbers below 1e-308, too.
  return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

/// The place value of the second significant digit of a positive number.
double unit_of_second_digit(double value) {
  return std::pow(10.0, std::floor(std::log10(value)) - 1.0);
}

constexpr double rounding_error = 1e-12;

}  // namespace

PrefixedNumber with_prefix(double value, int digits) {
  const PrefixedNumber plain{value, "", 1.0};
  if (value == 0.0 || !std::isfinite(value)) return plain;
  const double shown = std::abs(rounded(value, digits));
  if (shown >= 1000.0 * prefixes.front().scale) return plain;
  for (const auto& [name, scale] : prefixes) {
    if (shown >= scale) return {value / scale, name, scale};
  }
  return plain;
}

std::string display(double value, std::string_view unit, int digits) {
  const auto [number, prefix, scale] = with_prefix(value, digits);
  // "{:g}" would write 480 with two digits as 4.8e+02. The value is rounded first, as it is for the choice of the
  // prefix.
  const double shown = std::isfinite(number) ? rounded(rounded(value, digits) / scale, digits) : number;
  return fmt::format("{:.15g} {}{}", shown, prefix, unit);
}

std::string number_in_words(double value, std::string_view unit, int digits) {
  if (unit == "Pa" || unit == "m" || unit == "s") return display(value, unit, digits);
  return fmt::format("{:g}{}{}", rounded(value, digits), unit.empty() ? "" : " ", unit);
}

std::string three_digits(double value) {
  constexpr int digits = 3;
  return fmt::format("{:g}", rounded(value, digits));
}

std::string display_time(double seconds, int digits) {
  constexpr double thousand = 1e3, million = 1e6;
  const double shown = std::isfinite(seconds) ? rounded(seconds, digits) : seconds;
  if (!std::isfinite(shown) || std::abs(shown) < thousand) return display(seconds, "s", digits);
  if (std::abs(shown) < million) return fmt::format("{:.15g} s", shown);
  const double power = std::floor(std::log10(std::abs(shown)));
  return fmt::format("{:.15g}e{:.0f} s", rounded(shown / std::pow(10.0, power), digits), power);
}

std::string display_duration(double seconds, int digits) {
  struct Unit {
    std::string_view name;
    double size;  // [s]
  };
  // A unit is used from two units on: "90 s" instead of "1.5 min".
  for (const auto& [name, size] : {Unit{"d", 86400.0}, Unit{"h", 3600.0}, Unit{"min", 60.0}}) {
    if (seconds >= 2.0 * size) return fmt::format("{:.15g} {}", rounded(seconds / size, digits), name);
  }
  return display(seconds, "s", digits);
}

std::string display_beside(double value, double other, int digits) {
  constexpr int most_digits = 15;
  const auto shown = [](double number, int count) { return fmt::format("{:.{}g}", number, count); };
  while (digits < most_digits && shown(value, digits) == shown(other, digits)) ++digits;
  return shown(value, digits);
}

double rounded_down_to_two_digits(double value) {
  const double unit = unit_of_second_digit(value);
  return std::floor(value / unit * (1.0 + rounding_error)) * unit;
}

double rounded_up_to_two_digits(double value) {
  const double unit = unit_of_second_digit(value);
  return std::ceil(value / unit * (1.0 - rounding_error)) * unit;
}

std::string display_count(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace breccia
