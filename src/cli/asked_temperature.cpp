#include "cli/asked_temperature.hpp"

#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/units.hpp"

namespace breccia::cli {

AskedTemperature read_temperature(const std::string& text) {
  constexpr double zero_celsius = 273.15, smallest = 1e-6;
  const double kelvin = parse_quantity(text, Dimension::temperature);
  if (kelvin < 0.0) throw InputError(fmt::format("expected a temperature above absolute zero, got \"{}\"", text));
  const double celsius = std::round((kelvin - zero_celsius) / smallest) * smallest;
  return {kelvin, fmt::format("{:.6g} degC", celsius),
          fmt::format("respond-{}{:.6g}degC", celsius < 0.0 ? "minus" : "", std::abs(celsius))};
}

}  // namespace breccia::cli
