#pragma once

#include <petscksp.h>

namespace breccia::quasistatic {

/// Sets up a linear solver; `what` describes the operation in messages. Where several processes share Cholesky factors
/// by MUMPS, the memory that its analysis estimates may not suffice; it is then increased until it does. Call
/// require_no_breakdown() to check how the set-up ended.
void set_up_with_room(KSP solver, const char* what);

}  // namespace breccia::quasistatic
