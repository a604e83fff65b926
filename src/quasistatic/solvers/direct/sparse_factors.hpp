#pragma once

#include <petscksp.h>

namespace breccia::quasistatic {

/// Sets up a linear solver; `what` describes the operation in messages. Where several processes share Cholesky factors
/// by MUMPS, the room that its analysis foresees may not suffice: then there is more until it does. How the set-up
/// ended is told by require_no_breakdown().
void set_up_with_room(KSP solver, const char* what);

}  // namespace breccia::quasistatic
