#include "virtual_test/ringing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace breccia {

double ringing_after_ramp(double transits) {
  constexpr double period = 1.7;  // of the slowest mode, in transits
  const double periods = transits / period;
  // Ramps shorter than the period of a mode let it ring by most of its static response.
  if (periods <= 1.0) return 1.0;
  return std::min(1.0, 1.0 / (std::numbers::pi * periods * (periods * periods - 1.0)));
}

}  // namespace breccia
