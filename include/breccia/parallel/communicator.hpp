#pragma once

#include <mpi.h>

namespace breccia::parallel {

/// The processes of the group of this one (session.hpp), for MPI. Only after start().
MPI_Comm communicator() noexcept;

}  // namespace breccia::parallel
