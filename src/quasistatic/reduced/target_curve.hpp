#pragma once

#include <vector>

#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

struct ReducedResponse;

/// The relaxation modulus for which a reduced basis is made: that of the composite with these materials as its varying
/// phases, in the order of the phases, over these times [s].
struct TargetCurve {
  std::vector<Material> materials;
  TimeWindow times;
};

/// The largest change of the relaxation modulus, over the times of the target, by the last vector of the basis. It is
/// relative to the modulus or, where that is larger, to 1e-8 of the unrelaxed modulus. It is infinite while the basis
/// has one vector, or where one of the two moduli cannot be computed. The modulus at Laplace variables near 1/t may be
/// far more accurate than the modulus at the time t, if the composite has relaxed by orders of magnitude by then
/// (theory, section 10).
[[nodiscard]] double change_by_last_vector(const ReducedResponse& response, const TargetCurve& target);

}  // namespace breccia
