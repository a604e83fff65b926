#pragma once

#include <array>
#include <vector>

#include "element_matrices.hpp"

namespace disc_packings {

struct Moduli {
  double bulk, shear;  ///< bulk: the three-dimensional one
};

/// The apparent moduli of the box under the loads: twice the energy per area at each.
[[nodiscard]] std::array<double, 3> apparent_moduli(const std::vector<ElementMatrices>& elements, int unknowns,
                                                    const Moduli& binder, const Moduli& discs);

}  // namespace disc_packings
