#pragma once

#include <span>

#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia::quasistatic {

/// Largest error that rounding alone may cause in ReducedResponse::error_estimate [-]: the squared residual is a small
/// sum of large products of opposite signs. A smaller estimate is meaningless, and no further snapshot would reduce it.
double rounding_of_error_estimate(const ReducedResponse& response, std::span<const Moduli> of_phases);

/// Whether the residual is no larger than at the snapshot whose moduli are nearest. There the reduced response is
/// exact, and the residual is that of the solver.
bool has_residual_of_snapshot(const ReducedResponse& response, std::span<const Moduli> of_phases);

}  // namespace breccia::quasistatic
