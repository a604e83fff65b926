#pragma once

#include <array>
#include <cstddef>

namespace breccia {

/// A position or displacement in `dim` dimensions [m].
template <int dim>
using Vector = std::array<double, static_cast<std::size_t>(dim)>;

/// factor * length^exponent, multiplied from left to right.
template <int exponent>
[[nodiscard]] constexpr double times_power(double factor, double length) noexcept {
  for (int i = 0; i < exponent; ++i) factor *= length;
  return factor;
}

}  // namespace breccia
