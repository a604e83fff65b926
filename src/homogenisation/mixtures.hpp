#pragma once

namespace breccia {

/// The rule of mixtures for a property of a composite that is additive by volume: density [kg/m^3], or compliance under
/// uniform pressure [1/Pa]. `fraction` is the volume fraction of the filler [-].
constexpr double mixed(double matrix, double filler, double fraction) {
  return (1.0 - fraction) * matrix + fraction * filler;
}

}  // namespace breccia
