#pragma once

namespace breccia::parallel {

/// Number of threads of a calculation in this process: those asked for or, for 0, those of OMP_NUM_THREADS or, without
/// it, all cores. Cores on which several processes of a run may be placed are shared evenly between these, so that
/// mpirun does not start more threads than a machine has cores, whether it binds processes to cores or not. Under
/// mpirun all processes must make the first call together, which starts MPI.
int threads_for(int asked);

/// Finds the share of this process in the cores. Called once by all processes, when MPI has started.
void share_cores();

}  // namespace breccia::parallel
