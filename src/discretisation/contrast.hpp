#pragma once

#include <span>

#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Whether all other materials are softer in shear than the first one, the matrix, at all times.
[[nodiscard]] bool are_softer_than_matrix(std::span<const Material> by_phase);
/// Whether all other materials are stiffer in shear than the first one, the matrix, at all times.
[[nodiscard]] bool are_stiffer_than_matrix(std::span<const Material> by_phase);

}  // namespace breccia
