#include "report/even_values.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace breccia {

std::vector<EvenValue> even_values(double from, double to) {
  constexpr double count = 5.0, rounding = 1e-9;
  const double raw = (to - from) / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10.0 * power;
  for (const double size : {5.0, 2.0, 1.0}) {
    if (size * power >= raw * (1.0 - rounding)) step = size * power;
  }
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + rounding)));
  std::vector<EvenValue> values;
  for (double i = std::ceil(from / step - rounding); i * step <= to + rounding * step; ++i) {
    // Adding 0 removes the sign of a negative zero.
    const double value = i * step + 0.0;
    values.push_back({value, fmt::format("{:.{}f}", value, decimals)});
  }
  return values;
}

}  // namespace breccia
