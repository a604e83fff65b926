#pragma once

namespace breccia::parallel {

/// Number of threads of a calculation in this process: `asked` or, if it is 0, OMP_NUM_THREADS or, without it, the
/// number of cores on which the process may run. Processes of a run that may run on the same cores share them evenly,
/// whether mpirun binds processes to cores or not; but before start() (session.hpp), or if the host program has started
/// PETSc, each process counts all of them.
int threads_for(int asked);

/// Finds the share of this process in the cores. Called once by all processes, by start().
void share_cores();

}  // namespace breccia::parallel
