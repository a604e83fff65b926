#include "breccia/viscoelasticity/temperature_shift.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "viscoelasticity/temperature_text.hpp"

namespace breccia {

double WilliamsLandelFerry::shift_factor(double temperature) const {
  const double excess = temperature - reference_temperature;
  if (!(c2 + excess > 0.0)) {
    throw InputError(fmt::format("the shift law has no meaning at or below {} (reference temperature - c2), got {}",
                                 in_kelvin_and_celsius(reference_temperature - c2),
                                 in_kelvin_and_celsius(temperature)));
  }
  const double decades = -c1 * excess / (c2 + excess);
  constexpr double most_decades = 100.0;
  if (!(std::abs(decades) <= most_decades)) {
    throw InputError(fmt::format("the shift law shifts by 10^{:.3g} at {}, which is outside its range of use", decades,
                                 in_kelvin_and_celsius(temperature)));
  }
  return std::pow(10.0, decades);
}

double WilliamsLandelFerry::temperature_at(double log10_factor) const {
  if (log10_factor <= -c1) return std::numeric_limits<double>::infinity();
  return reference_temperature - c2 * log10_factor / (c1 + log10_factor);
}

WilliamsLandelFerry arrhenius(double activation_energy, double reference_temperature) {
  constexpr double gas_constant = 8.31446261815324;  // [J/(mol K)], exact since 2019
  return {activation_energy / (gas_constant * reference_temperature * std::numbers::ln10), reference_temperature,
          reference_temperature};
}

double shift_factor(const ShiftLaw& law, double temperature) {
  return std::visit([temperature](const auto& one) { return one.shift_factor(temperature); }, law);
}

}  // namespace breccia
