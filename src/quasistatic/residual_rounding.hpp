#pragma once

#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia::quasistatic {

/// What rounding may contribute to ReducedResponse::error_estimate: the residual is the small sum of large products
/// with opposite signs [-]. An estimate below that says nothing, and no further solution would make it smaller.
double rounding_of_error_estimate(const ReducedResponse& response, const Moduli& matrix);

}  // namespace breccia::quasistatic
