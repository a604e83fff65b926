#pragma once

#include <span>
#include <vector>

#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia::quasistatic {

/// Creep compliance [1/Pa] of a reduced response whose varying phases are of these materials, which may all relax in
/// shear and in volume: a network of r x r spring and dashpot matrices, one pair for every relaxation time, solved as
/// one symmetric eigenproblem (theory, Eq. 20).
CreepCompliance network_compliance(const ReducedResponse& response, std::span<const Material> of_phases);

/// The displacement of a reduced response at one time, and the moduli that vary applied to its history: weights of the
/// r vectors of the basis.
struct ReducedState {
  Eigen::VectorXd displacement;          ///< c
  std::vector<Eigen::VectorXd> applied;  ///< by part: its modulus applied to the history of c [Pa]
};

/// State of the same network at a time [s] after its load was applied and held: the unit load e under a traction
/// boundary, the unit strain e' c = 1 under the others (theory, Eq. 34).
ReducedState network_state(const ReducedResponse& response, std::span<const Material> of_phases, double time);

}  // namespace breccia::quasistatic
