#pragma once

#include <array>
#include <string>

#include "breccia/discretisation/plane_tensor.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The load of a virtual test. Under each, the modulus is stress : unit_strain(load).
enum class Load {
  shear,           ///< pure shear of the axes, xy; the modulus is G
  diagonal_shear,  ///< pure shear of the diagonals, xx - yy; the modulus is G
  bulk             ///< equibiaxial in-plane strain; the modulus is the plane-strain bulk modulus K + G / 3
};

template <>
inline constexpr auto words<Load> =
    std::to_array<Word<Load>>({{"shear", Load::shear}, {"shear-xx-yy", Load::diagonal_shear}, {"bulk", Load::bulk}});

/// Strain with engineering shear or in-plane dilatation 1. A body of modulus M stores M/2 per area under it; the
/// traction of the stress 2 unit_strain(load) [1 Pa] deforms it by 1/M.
constexpr PlaneStrain unit_strain(Load load) noexcept {
  switch (load) {
    case Load::shear:
      return {.xy = 0.5};
    case Load::diagonal_shear:
      return {.xx = 0.5, .yy = -0.5};
    case Load::bulk:
      return {.xx = 0.5, .yy = 0.5};
  }
  return {};
}

/// Modulus [Pa] that a stress [Pa] under the unit strain of a load tells.
constexpr double modulus_of(Load load, const PlaneStress& stress) noexcept {
  const auto strain = unit_strain(load);
  return stress.xx * strain.xx + stress.yy * strain.yy + 2.0 * stress.xy * strain.xy;
}

/// Compliance [1/Pa] that a strain under the traction of the stress 2 unit_strain(load) [1 Pa] tells.
constexpr double compliance_of(Load load, const PlaneStrain& strain) noexcept {
  const auto unit = unit_strain(load);
  return 2.0 * (strain.xx * unit.xx + strain.yy * unit.yy + 2.0 * strain.xy * unit.xy);
}

/// The boundary condition of a virtual test. The first two give apparent moduli of the box that bound the effective
/// ones from above and from below, in the mean over many boxes (Huet 1990).
enum class Boundary {
  displacement,  ///< kinematic uniform (KUBC): nodes on the boundary follow the affine motion of the load
  traction,      ///< static uniform (SUBC): the uniform traction of the load's stress acts on the boundary
  periodic       ///< displacements on opposite sides differ by the affine motion of the load
};

template <>
inline constexpr auto words<Boundary> = std::to_array<Word<Boundary>>({{"displacement", Boundary::displacement},
                                                                       {"traction", Boundary::traction},
                                                                       {"periodic", Boundary::periodic}});

/// "upper bound", "lower bound" or "periodic": what the apparent modulus under a boundary condition is to the effective
/// one.
std::string bound_of(Boundary boundary);

}  // namespace breccia
