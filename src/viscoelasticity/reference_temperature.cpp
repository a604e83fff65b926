#include "viscoelasticity/reference_temperature.hpp"

namespace breccia {

WilliamsLandelFerry with_reference(const WilliamsLandelFerry& law, double temperature) {
  static_cast<void>(law.shift_factor(temperature));  // refuses temperatures without a meaning
  const double c2 = law.c2 + (temperature - law.reference_temperature);
  return {law.c1 * law.c2 / c2, c2, temperature};
}

ShiftTable with_reference(const ShiftTable& table, double temperature) {
  return {table.temperatures(), table.log10_factors(), temperature};
}

}  // namespace breccia
