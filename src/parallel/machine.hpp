#pragma once

#include <cstddef>
#include <memory>

namespace breccia::parallel {

// The processes of the group that run on one machine. The first call of any of these functions is collective: every
// process of the group must make it. Without mpirun a process is alone on its machine, and MPI is not started.

/// The rank of this process among those on its machine, from 0.
[[nodiscard]] int rank_on_machine();
/// The number of processes of the group on this machine.
[[nodiscard]] int ranks_on_machine();

/// Memory of this number of bytes, all zero, that the processes on this machine share; each releases it by itself, at
/// any time. All of them must call the function. Writes of other processes are visible after a barrier. Null on all of
/// them where the system does not let one process map the memory of another, or does not have as much memory. The
/// memory is a file without a name, which the other processes open through /proc. A window of MPI would have to be
/// released by all processes at once, and Open MPI keeps it in /dev/shm, which has 64 MB in many containers.
[[nodiscard]] std::shared_ptr<std::byte> common_memory(std::size_t bytes);

}  // namespace breccia::parallel
