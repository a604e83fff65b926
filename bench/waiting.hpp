#pragma once

/// Processor time that this process has spent on looking for messages [s]. Processes that share a core wait for each
/// other most of the time, and waiting is no work. The time is measured under Open MPI; it is 0 under another MPI. Some
/// of the work of MUMPS on its smallest fronts counts as waiting, and times by the clock are longer for it.
double seconds_waited() noexcept;
