#pragma once

#include <span>
#include <vector>

#include "breccia/quasistatic/reduced_response.hpp"

#include "virtual_test/quasistatic_test.hpp"

namespace breccia {

/// The response of a composite whose varying phases are of these materials, at these times [s], without an estimate of
/// its error: series and curves follow exactly from the reduced stiffness (creep_compliance). The compliance is
/// sampled under a traction boundary alone.
QuasistaticResponse reduced_curves(const ReducedResponse& reduced, std::span<const Material> of_phases,
                                   const std::vector<double>& times);

}  // namespace breccia
