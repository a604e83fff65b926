#pragma once

#include <petscksp.h>

namespace breccia::quasistatic {

/// The reason for which a linear solver ended its last set-up or solution. Throws NumericalError when it broke down:
/// with the caller's message when the preconditioner failed or numbers became infinite, which are also the signs of a
/// lack of memory; with a message of its own when the matrix is not positive definite.
KSPConvergedReason require_no_breakdown(KSP solver, const char* cannot_be_prepared);

}  // namespace breccia::quasistatic
