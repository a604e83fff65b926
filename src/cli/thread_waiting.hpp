#pragma once

namespace breccia::cli {

/// Starts the program anew, with the same arguments and as the same process, if the threads of libgomp would otherwise
/// wait for one another for a millisecond with the core kept busy before they sleep. Two runs side by side then keep
/// each other's working threads from the cores: two runs of 20^3 cells on two cores took 37 s each, and 3 s with
/// threads that sleep after a few microseconds, which costs a run alone nothing. libgomp reads its environment once,
/// before main().
///
/// Nothing happens where OMP_WAIT_POLICY or GOMP_SPINCOUNT says how threads wait, and where the system cannot start the
/// program anew.
void have_threads_sleep_soon(char** arguments);

}  // namespace breccia::cli
