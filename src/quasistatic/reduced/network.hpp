#pragma once

#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia::quasistatic {

/// Creep compliance [1/Pa] of a reduced response whose matrix relaxes in shear and in volume: a network of r x r spring
/// and dashpot matrices, one pair for every relaxation time, solved as one symmetric eigenproblem (theory, Eq. 20).
CreepCompliance network_compliance(const ReducedResponse& response, const Material& matrix);

/// The displacement of a reduced response at one time, and the moduli of the matrix applied to its history: weights of
/// the r vectors of the basis.
struct ReducedState {
  Eigen::VectorXd displacement;  ///< c
  Eigen::VectorXd shear;         ///< the shear modulus of the matrix applied to the history of c [Pa]
  Eigen::VectorXd bulk;          ///< the bulk modulus of the matrix applied to the history of c [Pa]
};

/// State of the same network at a time [s] after its load was applied and held: the unit load e under a traction
/// boundary, the unit strain e' c = 1 under the others (theory, Eq. 34).
ReducedState network_state(const ReducedResponse& response, const Material& matrix, double time);

}  // namespace breccia::quasistatic
