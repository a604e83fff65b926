#pragma once

#include <cstddef>
#include <memory>

namespace breccia::parallel {

// The processes of the group that run on the same machine. Each process of the group must make the first of these
// calls; without mpirun a process is alone on its machine.

/// The rank of this process among them, from 0.
[[nodiscard]] int rank_on_machine();
/// Their number.
[[nodiscard]] int ranks_on_machine();

/// Memory of so many bytes, all zero, that they have in common. All of them must call the function, and see what others
/// have written after a barrier. Null on all of them where the system does not let one process map the memory of
/// another.
[[nodiscard]] std::shared_ptr<std::byte> common_memory(std::size_t bytes);

}  // namespace breccia::parallel
