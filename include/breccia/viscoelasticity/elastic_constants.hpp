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

/// Moduli of an aggregate of crystals without any texture [Pa]. No such aggregate is stiffer than the mean of the
/// stiffnesses (Voigt) or softer than that of the compliances (Reuss).
struct IsotropicMeans {
  double bulk_voigt, bulk_reuss, shear_voigt, shear_reuss;

  /// Hill's means of the two (1952).
  [[nodiscard]] double bulk() const { return 0.5 * (bulk_voigt + bulk_reuss); }
  [[nodiscard]] double shear() const { return 0.5 * (shear_voigt + shear_reuss); }
};

/// The least eigenvalue of the stiffness in an orthonormal basis of the strains [Pa]: positive for a stable solid.
[[nodiscard]] double least_stiffness(const ElasticConstants& constants);

/// The isotropic means of the constants of a stable solid.
[[nodiscard]] IsotropicMeans isotropic_means(const ElasticConstants& constants);

}  // namespace breccia
