#pragma once

namespace breccia::parallel {

/// Number of threads of a calculation in this process: those asked for or, for 0, those of OMP_NUM_THREADS or, without
/// it, all cores on which the process may run. Several processes of a run that may run on the same cores share them
/// evenly, whether mpirun binds processes to cores or not. This holds once start() has run (session.hpp) and unless the
/// host program has started PETSc; before, and then, each process takes all of them.
int threads_for(int asked);

/// Finds the share of this process in the cores. Called once by all processes, by start().
void share_cores();

}  // namespace breccia::parallel
