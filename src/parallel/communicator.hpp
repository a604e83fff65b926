#pragma once

#include <mpi.h>

namespace breccia::parallel {

/// The MPI communicator of the group of this process (session.hpp). Valid after start().
MPI_Comm communicator() noexcept;

/// The communicator of the processes of the group on this machine (machine.hpp). The first call is collective: every
/// process of the group must make it. Valid after start().
MPI_Comm machine_communicator();

}  // namespace breccia::parallel
