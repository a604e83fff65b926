#pragma once

#include <span>

#include "breccia/quasistatic/reduced_response.hpp"

#include "quasistatic/reduced/composite_state.hpp"

namespace breccia::quasistatic {

/// Creep compliance [1/Pa] of a reduced response whose varying phases are of these materials, which may all relax in
/// shear and in volume: a network of r x r spring and dashpot matrices, one pair for every relaxation time, solved as
/// one symmetric eigenproblem (theory, Eq. 20).
CreepCompliance network_compliance(const ReducedResponse& response, std::span<const Material> of_phases);

/// State of a reduced response whose varying phases are of these materials, at a time [s] after its load was applied
/// and held: the unit load e under a traction boundary, the unit strain e' c = 1 under the other boundaries (theory,
/// Eq. 34).
[[nodiscard]] ReducedState network_state(const ReducedResponse& response, std::span<const Material> of_phases,
                                         double time);

}  // namespace breccia::quasistatic
