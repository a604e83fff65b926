#include "report/bar_ticks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/display.hpp"
#include "report/even_values.hpp"

namespace breccia {
namespace {

constexpr double rounding = 1e-9;

std::vector<BarTick> even_ticks(double from, double to) {
  std::vector<BarTick> ticks;
  for (const auto& [value, label] : even_values(from, to)) ticks.push_back({(value - from) / (to - from), label});
  return ticks;
}

std::vector<BarTick> logarithmic_ticks(double from, double to) {
  constexpr double few = 2.0, many = 7.0;
  const double decades = std::log10(to / from);
  const auto every = static_cast<int>(std::max(1.0, std::ceil(decades / many)));
  std::vector<BarTick> ticks;
  for (auto power = static_cast<int>(std::floor(std::log10(from))); power <= std::log10(to); ++power) {
    if (power % every != 0) continue;
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double value = digit * std::pow(10.0, power);
      if ((digit > 1.0 && decades > few) || value < from * (1.0 - rounding) || value > to * (1.0 + rounding)) continue;
      ticks.push_back({std::log10(value / from) / decades, three_digits(value)});
    }
  }
  return ticks;
}

}  // namespace

std::vector<BarTick> bar_ticks(const ColourRange& colours, double unit_size) {
  const auto [from, to] = std::minmax({colours.value_at(0.0) / unit_size, colours.value_at(1.0) / unit_size});
  if (!std::isfinite(from) || !std::isfinite(to)) return {};
  // A field that is the same everywhere has one value, and no scale.
  if (!(from < to)) return {{0.5, three_digits(from)}};
  const bool is_logarithmic = colours.is_logarithmic() && from > 0.0;
  auto ticks = is_logarithmic ? logarithmic_ticks(from, to) : std::vector<BarTick>();
  // A fraction of a decade may contain none of these values.
  if (ticks.size() < 2) {
    ticks = even_ticks(from, to);
    if (is_logarithmic) {
      for (auto& tick : ticks) tick.share = std::log((from + tick.share * (to - from)) / from) / std::log(to / from);
    }
  }
  // A unit may be negative: the mean of a strain.
  if (unit_size < 0.0) {
    for (auto& tick : ticks) tick.share = 1.0 - tick.share;
  }
  return ticks;
}

}  // namespace breccia
