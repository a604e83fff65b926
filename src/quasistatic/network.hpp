#pragma once

#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia::quasistatic {

/// Creep compliance of a reduced response whose matrix relaxes in shear and in volume: a network of r x r springs and
/// dashpots with a time for every term, solved as one symmetric eigenproblem (theory, Eq. 20).
CreepCompliance network_compliance(const ReducedResponse& response, const Material& matrix);

/// Weights of the r vectors of a basis at a time.
struct ReducedState {
  Eigen::VectorXd displacement;  ///< c
  Eigen::VectorXd shear;         ///< the shear modulus of the matrix applied to the history of c [Pa]
  Eigen::VectorXd bulk;          ///< its bulk modulus applied to it [Pa]
};

/// The state of the same network at a time [s] after its load was applied: under a traction boundary the unit load e,
/// under the others a strain, e' c = 1, that is held (theory, Eq. 34).
ReducedState network_state(const ReducedResponse& response, const Material& matrix, double time);

}  // namespace breccia::quasistatic
