#pragma once

namespace breccia::cli {

/// Makes threads that wait for one another sleep after some microseconds: starts the program anew, as the same process
/// and with the same arguments, with GOMP_SPINCOUNT set, which libgomp reads before main(). By default its threads keep
/// their cores busy for a millisecond first. Two runs side by side then keep each other's working threads from the
/// cores: two runs of 20^3 cells on two cores took 37 s each, and 3 s with this setting, which costs a single run
/// nothing.
///
/// Does nothing where OMP_WAIT_POLICY or GOMP_SPINCOUNT says how threads wait, and where the system cannot start the
/// program anew.
void have_threads_sleep_soon(char** arguments);

}  // namespace breccia::cli
