#pragma once

#include <cstdint>

namespace breccia::parallel {

/// Number of threads of a calculation in this process: `asked` or, if it is 0, OMP_NUM_THREADS or, without it, the
/// number of cores on which the process may run. Processes of a run that may run on the same cores share them evenly,
/// whether mpirun binds processes to cores or not; but before start() (session.hpp), or if the host program has started
/// PETSc, each process counts all of them.
int threads_for(int asked);

/// As threads_for(asked), but without a wish, in `asked` or in OMP_NUM_THREADS, no more threads than gain from the
/// work: `pieces` of it in all, of which each thread needs `least` to take longer than the threads wait for one
/// another.
int threads_for(int asked, std::int64_t pieces, std::int64_t least);

/// Finds the share of this process in the cores. Called once by all processes, by start().
void share_cores();

}  // namespace breccia::parallel
