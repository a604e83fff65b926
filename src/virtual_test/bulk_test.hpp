#pragma once

#include <string_view>

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

// The bulk test strains a box equally along all axes. In a cube its modulus is K(t), in plane strain K(t) + G(t)/3.

/// Whether bodies of so many dimensions are tested in plane strain.
[[nodiscard]] constexpr bool is_plane_strain(int dimensions) noexcept {
  return dimensions == 2;
}

/// The share of the shear modulus in the modulus of the bulk test [-].
[[nodiscard]] double shear_in_bulk_test(int dimensions);

/// The bulk modulus K(t) of a body from its moduli in the bulk test and in shear.
[[nodiscard]] PronySeries bulk_modulus_of(const PronySeries& bulk_test, const PronySeries& shear, int dimensions);

/// The modulus of the bulk test as a formula: "K", "K + G/3".
[[nodiscard]] std::string_view symbol_of_bulk_test(int dimensions);

/// The modulus of the bulk test as a function of time: "K(t)", "K(t) + G(t)/3".
[[nodiscard]] std::string_view formula_of_bulk_test(int dimensions);

}  // namespace breccia
