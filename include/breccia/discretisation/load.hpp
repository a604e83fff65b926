#pragma once

#include <array>

#include "breccia/discretisation/tensor.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The load of a virtual test. Under each, the modulus is stress : unit_strain(load).
enum class Load {
  shear,           ///< pure shear of the axes, xy; the modulus is G
  diagonal_shear,  ///< pure shear of the diagonals, xx - yy; the modulus is G
  bulk             ///< equal strain along all axes; the modulus is K, in plane strain K + G / 3
};

template <>
inline constexpr auto words<Load> =
    std::to_array<Word<Load>>({{"shear", Load::shear}, {"shear-xx-yy", Load::diagonal_shear}, {"bulk", Load::bulk}});

/// Strain with engineering shear or dilatation 1. A body of modulus M stores M/2 per volume under it.
template <int dim>
[[nodiscard]] constexpr Strain<dim> unit_strain(Load load) noexcept {
  Strain<dim> strain;
  switch (load) {
    case Load::shear:
      strain.xy = 0.5;
      break;
    case Load::diagonal_shear:
      strain.xx = 0.5;
      strain.yy = -0.5;
      break;
    case Load::bulk:
      for (int axis = 0; axis < dim; ++axis) component(strain, axis) = 1.0 / dim;
      break;
  }
  return strain;
}

/// Stress [1 Pa] of the same shape whose work on the unit strain is 1 per volume. It deforms a body of modulus M by
/// unit_strain(load) times 1/M.
template <int dim>
[[nodiscard]] constexpr Stress<dim> unit_stress(Load load) noexcept {
  const auto strain = unit_strain<dim>(load);
  const double squared = contraction(strain, strain);
  Stress<dim> stress;
  for (int place = 0; place < tensor_components<dim>; ++place) {
    component(stress, place) = component(strain, place) / squared;
  }
  return stress;
}

/// Modulus [Pa] from the stress [Pa] under the unit strain of a load.
template <int dim>
[[nodiscard]] constexpr double modulus_of(Load load, const Stress<dim>& stress) noexcept {
  return contraction(stress, unit_strain<dim>(load));
}

/// Compliance [1/Pa] from the strain under the unit stress of a load.
template <int dim>
[[nodiscard]] constexpr double compliance_of(Load load, const Strain<dim>& strain) noexcept {
  return contraction(strain, unit_stress<dim>(load));
}

}  // namespace breccia
