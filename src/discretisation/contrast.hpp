#pragma once

#include <span>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Whether all other materials are softer in shear than the first one, the matrix, at all times.
[[nodiscard]] bool are_softer_than_matrix(std::span<const Material> by_phase);
/// Whether all other materials are stiffer in shear than the first one, the matrix, at all times.
[[nodiscard]] bool are_stiffer_than_matrix(std::span<const Material> by_phase);
/// The least bulk and the least shear modulus of all phases that are no voids [Pa]; infinite without any.
[[nodiscard]] Moduli least_of_solids(std::span<const Moduli> by_phase);

}  // namespace breccia
