#pragma once

#include <array>
#include <vector>

#include "boundary.hpp"
#include "element_matrices.hpp"
#include "unknowns.hpp"

namespace disc_packings {

struct Moduli {
  double bulk, shear;  ///< bulk: the three-dimensional one
};

/// The apparent moduli of the box under the loads: twice the energy per area at each strain or, where the tractions are
/// given, one over twice the energy at each stress.
[[nodiscard]] std::array<double, 3> apparent_moduli(const std::vector<ElementMatrices>& elements,
                                                    const Unknowns& unknowns, Boundary boundary, const Moduli& binder,
                                                    const Moduli& discs);

}  // namespace disc_packings
