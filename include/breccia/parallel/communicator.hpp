#pragma once

#include <mpi.h>

namespace breccia::parallel {

/// The MPI communicator of the group of this process (session.hpp). Valid after start().
MPI_Comm communicator() noexcept;

}  // namespace breccia::parallel
