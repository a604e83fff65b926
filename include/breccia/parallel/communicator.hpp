#pragma once

#include <mpi.h>

namespace breccia::parallel {

/// The MPI communicator of the group of this process (session.hpp). Valid after start().
MPI_Comm communicator() noexcept;

/// That of the processes of the group which run on the same machine (machine.hpp); that of this process alone without
/// mpirun, where MPI need not have started. Each process of the group must make the first call.
MPI_Comm machine_communicator();

}  // namespace breccia::parallel
