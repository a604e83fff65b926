#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "breccia/discretisation/tensor.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The load of a virtual test. The modulus under a load is stress : unit_strain(load). Those along z exist in 3
/// dimensions only. Three shears of axes, xx - yy, the axial shear and bulk are orthogonal to each other and span all
/// strains; two of them at once are a load, too, whose unit strain is the sum of theirs (pairs_of_loads).
enum class Load {
  shear,              ///< pure shear of the axes, xy; the modulus is G
  diagonal_shear,     ///< pure shear of the diagonals, xx - yy; the modulus is G
  bulk,               ///< equal strain along all axes; the modulus is K, in plane strain K + G / 3
  shear_yz,           ///< pure shear of the axes y and z
  shear_zx,           ///< pure shear of the axes z and x
  diagonal_shear_yz,  ///< pure shear of the diagonals, yy - zz
  axial_shear,        ///< extension along z at constant volume, 2 zz - xx - yy; the modulus is G
  shear_and_diagonal_shear,
  shear_and_bulk,
  diagonal_shear_and_bulk,
  shear_and_shear_yz,
  shear_and_shear_zx,
  shear_and_axial_shear,
  diagonal_shear_and_shear_yz,
  diagonal_shear_and_shear_zx,
  diagonal_shear_and_axial_shear,
  bulk_and_shear_yz,
  bulk_and_shear_zx,
  bulk_and_axial_shear,
  shear_yz_and_shear_zx,
  shear_yz_and_axial_shear,
  shear_zx_and_axial_shear
};

template <>
inline constexpr auto words<Load> = std::to_array<Word<Load>>({{"shear", Load::shear},
                                                               {"shear-xx-yy", Load::diagonal_shear},
                                                               {"bulk", Load::bulk},
                                                               {"shear-yz", Load::shear_yz},
                                                               {"shear-zx", Load::shear_zx},
                                                               {"shear-yy-zz", Load::diagonal_shear_yz},
                                                               {"shear-zz", Load::axial_shear}});

/// Two loads at once.
struct LoadPair {
  Load both;
  Load one, other;
};

/// The pairs of loads that span all strains, those of the plane first. With the moduli of the single loads, the moduli
/// of the pairs give the whole stiffness (theory, Eq. 13c).
inline constexpr std::array<LoadPair, 15> pairs_of_loads{
    {{Load::shear_and_diagonal_shear, Load::shear, Load::diagonal_shear},
     {Load::shear_and_bulk, Load::shear, Load::bulk},
     {Load::diagonal_shear_and_bulk, Load::diagonal_shear, Load::bulk},
     {Load::shear_and_shear_yz, Load::shear, Load::shear_yz},
     {Load::shear_and_shear_zx, Load::shear, Load::shear_zx},
     {Load::shear_and_axial_shear, Load::shear, Load::axial_shear},
     {Load::diagonal_shear_and_shear_yz, Load::diagonal_shear, Load::shear_yz},
     {Load::diagonal_shear_and_shear_zx, Load::diagonal_shear, Load::shear_zx},
     {Load::diagonal_shear_and_axial_shear, Load::diagonal_shear, Load::axial_shear},
     {Load::bulk_and_shear_yz, Load::bulk, Load::shear_yz},
     {Load::bulk_and_shear_zx, Load::bulk, Load::shear_zx},
     {Load::bulk_and_axial_shear, Load::bulk, Load::axial_shear},
     {Load::shear_yz_and_shear_zx, Load::shear_yz, Load::shear_zx},
     {Load::shear_yz_and_axial_shear, Load::shear_yz, Load::axial_shear},
     {Load::shear_zx_and_axial_shear, Load::shear_zx, Load::axial_shear}}};

/// The two loads of a pair; nothing for a single load.
[[nodiscard]] constexpr std::optional<LoadPair> pair_of(Load load) noexcept {
  for (const auto& pair : pairs_of_loads) {
    if (pair.both == load) return pair;
  }
  return std::nullopt;
}

/// The name of a load: its word or, of a pair, both words, "shear + bulk".
[[nodiscard]] std::string name_of(Load load);

/// Whether a load exists in `dim` dimensions.
template <int dim>
[[nodiscard]] constexpr bool has_load(Load load) noexcept {
  if (const auto pair = pair_of(load)) return has_load<dim>(pair->one) && has_load<dim>(pair->other);
  return dim > 2 || load == Load::shear || load == Load::diagonal_shear || load == Load::bulk;
}

/// Throws InputError, with the name of the calculation, for the first of these loads that does not exist in this number
/// of dimensions.
void require_loads(std::string_view calculation, int dimensions, std::span<const Load> loads);

/// The unit strain of a load: its engineering shear, or its dilatation, is 1; of a pair, both are. A body of modulus M
/// stores the energy M/2 per volume under it. It is zero for a load that does not exist in this number of dimensions.
template <int dim>
[[nodiscard]] constexpr Strain<dim> unit_strain(Load load) noexcept {
  Strain<dim> strain;
  if (!has_load<dim>(load)) return strain;
  if (const auto pair = pair_of(load)) {
    const auto one = unit_strain<dim>(pair->one), other = unit_strain<dim>(pair->other);
    for (int index = 0; index < tensor_components<dim>; ++index) {
      component(strain, index) = component(one, index) + component(other, index);
    }
    return strain;
  }
  constexpr int x = 0, y = 1, z = 2;
  const auto shear = [&strain](int i, int j) { component(strain, component_index<dim>(i, j)) = 0.5; };
  const auto diagonal_shear = [&strain](int i, int j) {
    component(strain, i) = 0.5;
    component(strain, j) = -0.5;
  };
  switch (load) {
    case Load::shear:
      shear(x, y);
      break;
    case Load::diagonal_shear:
      diagonal_shear(x, y);
      break;
    case Load::bulk:
      for (int axis = 0; axis < dim; ++axis) component(strain, axis) = 1.0 / dim;
      break;
    case Load::shear_yz:
      shear(y, z);
      break;
    case Load::shear_zx:
      shear(z, x);
      break;
    case Load::diagonal_shear_yz:
      diagonal_shear(y, z);
      break;
    case Load::axial_shear:
      component(strain, x) = component(strain, y) = -0.5 / std::numbers::sqrt3;
      component(strain, z) = 1.0 / std::numbers::sqrt3;
      break;
    case Load::shear_and_diagonal_shear:
    case Load::shear_and_bulk:
    case Load::diagonal_shear_and_bulk:
    case Load::shear_and_shear_yz:
    case Load::shear_and_shear_zx:
    case Load::shear_and_axial_shear:
    case Load::diagonal_shear_and_shear_yz:
    case Load::diagonal_shear_and_shear_zx:
    case Load::diagonal_shear_and_axial_shear:
    case Load::bulk_and_shear_yz:
    case Load::bulk_and_shear_zx:
    case Load::bulk_and_axial_shear:
    case Load::shear_yz_and_shear_zx:
    case Load::shear_yz_and_axial_shear:
    case Load::shear_zx_and_axial_shear:
      break;  // pairs, see above
  }
  return strain;
}

/// The unit stress of a load [1 Pa]: proportional to the unit strain, with a work of 1 per volume on it. It deforms a
/// body of modulus M by unit_strain(load) times 1/M.
template <int dim>
[[nodiscard]] constexpr Stress<dim> unit_stress(Load load) noexcept {
  const auto strain = unit_strain<dim>(load);
  const double squared = contraction(strain, strain);
  Stress<dim> stress;
  for (int index = 0; index < tensor_components<dim>; ++index) {
    component(stress, index) = component(strain, index) / squared;
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
