#pragma once

#include <array>
#include <cstddef>

namespace breccia {

/// The 21 elastic constants of an anisotropic solid [Pa]: C_ij with i <= j, row by row, of the stiffness that takes the
/// strains xx, yy, zz and the engineering shears yz, zx, xy in the axes of the crystal to the stresses in the same
/// order (Voigt's notation).
using ElasticConstants = std::array<double, 21>;

/// The place of C_ij among the constants; i and j count from 1, as they are written.
[[nodiscard]] constexpr std::size_t place_of_constant(std::size_t i, std::size_t j) noexcept {
  const std::size_t row = (i < j ? i : j) - 1, column = (i < j ? j : i) - 1;
  return 6 * row - row * (row + 1) / 2 + column;
}

}  // namespace breccia
