#include "breccia/viscoelasticity/temperature_shift.hpp"

#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

double WilliamsLandelFerry::shift_factor(double temperature) const {
  const double excess = temperature - reference_temperature;
  if (!(c2 + excess > 0.0)) {
    throw InputError(fmt::format("the WLF law has no meaning at or below {} K (reference temperature - c2), got {} K",
                                 reference_temperature - c2, temperature));
  }
  return std::pow(10.0, -c1 * excess / (c2 + excess));
}

}  // namespace breccia
