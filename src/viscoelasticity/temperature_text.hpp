#pragma once

#include <string>

#include <fmt/format.h>

namespace breccia {

/// A temperature [K] as text: "172.35 K (-100.8 degC)".
inline std::string in_kelvin_and_celsius(double temperature) {
  constexpr double zero_celsius = 273.15;
  return fmt::format("{:.7g} K ({:.5g} degC)", temperature, temperature - zero_celsius);
}

}  // namespace breccia
