#pragma once

namespace breccia {

/// Elastic moduli of a point or a phase.
struct Moduli {
  double bulk;   ///< [Pa]
  double shear;  ///< [Pa]
};

/// Whether moduli are those of a void.
constexpr bool is_void(const Moduli& moduli) noexcept {
  return moduli.bulk == 0.0 && moduli.shear == 0.0;
}

/// The modulus of equal strains along all axes [Pa]: the bulk modulus K in 3D, K + G/3 in plane strain, where nothing
/// strains out of the plane.
template <int dim>
constexpr double dilatational_modulus(const Moduli& moduli) noexcept {
  return dim == 2 ? moduli.bulk + moduli.shear / 3.0 : moduli.bulk;
}

}  // namespace breccia
