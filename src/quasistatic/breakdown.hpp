#pragma once

#include <petscksp.h>

namespace breccia::quasistatic {

/// Why a linear solver ended its last setup or solution. Throws NumericalError where it broke down: with a message of
/// the caller where it could not be prepared, or its numbers are no longer finite (a lack of memory shows itself in
/// these ways), with one of its own where the matrix is not positive definite.
KSPConvergedReason require_no_breakdown(KSP solver, const char* cannot_be_prepared);

}  // namespace breccia::quasistatic
