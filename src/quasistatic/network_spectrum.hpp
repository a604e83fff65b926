#pragma once

#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia::quasistatic {

/// Creep compliance of a reduced response whose matrix relaxes in shear and in volume: a network of r x r springs and
/// dashpots with a time for every term, solved as one symmetric eigenproblem (theory, Eq. 20).
CreepCompliance network_compliance(const ReducedResponse& response, const Material& matrix);

}  // namespace breccia::quasistatic
