#pragma once

namespace breccia {

/// A property of a composite that adds up by volume: density [kg/m^3], or compliance under one pressure [1/Pa].
/// `fraction` is that of the filler [-].
constexpr double mixed(double matrix, double filler, double fraction) {
  return (1.0 - fraction) * matrix + fraction * filler;
}

}  // namespace breccia
