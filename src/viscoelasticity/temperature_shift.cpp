#include "breccia/viscoelasticity/temperature_shift.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

namespace {

/// A temperature [K] as text: "172.35 K (-100.8 degC)".
std::string in_both_scales(double temperature) {
  constexpr double zero_celsius = 273.15;
  return fmt::format("{:.7g} K ({:.5g} degC)", temperature, temperature - zero_celsius);
}

}  // namespace

double WilliamsLandelFerry::shift_factor(double temperature) const {
  const double excess = temperature - reference_temperature;
  if (!(c2 + excess > 0.0)) {
    throw InputError(fmt::format("the WLF law has no meaning at or below {} (reference temperature - c2), got {}",
                                 in_both_scales(reference_temperature - c2), in_both_scales(temperature)));
  }
  const double decades = -c1 * excess / (c2 + excess);
  constexpr double most_decades = 100.0;
  if (!(std::abs(decades) <= most_decades)) {
    throw InputError(fmt::format("the WLF law shifts by 10^{:.3g} at {}, which is outside its range of use", decades,
                                 in_both_scales(temperature)));
  }
  return std::pow(10.0, decades);
}

}  // namespace breccia
