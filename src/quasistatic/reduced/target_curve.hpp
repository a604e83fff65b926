#pragma once

#include <vector>

#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

struct ReducedResponse;

/// The relaxation modulus for which a reduced basis is made: that of the composite whose varying phases are of these
/// materials, in their order, over these times [s].
struct TargetCurve {
  std::vector<Material> materials;
  TimeWindow times;
};

/// The largest change of the relaxation modulus over the times of the target that the last vector of the basis has
/// made, relative to the modulus or to 1e-8 of the unrelaxed one where that is more; infinite while the basis has one
/// vector, or where either modulus cannot be computed. A modulus at Laplace variables of the size of 1/t may be far
/// more accurate than the one at a time t by which the composite has relaxed by orders of magnitude (theory, section
/// 10).
[[nodiscard]] double change_by_last_vector(const ReducedResponse& response, const TargetCurve& target);

}  // namespace breccia
