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
  const double decades = -c1 * excess / (c2 + excess);
  constexpr double most_decades = 100.0;
  if (!(std::abs(decades) <= most_decades)) {
    throw InputError(
        fmt::format("the WLF law shifts by 10^{:.3g} at {} K, which is beyond its use", decades, temperature));
  }
  return std::pow(10.0, decades);
}

}  // namespace breccia
