#pragma once

/// Processor time that this process has spent on looking for messages [s]. Processes that share a core wait for each
/// other most of the time, which is no work. Measured under Open MPI; 0 under another MPI. Some
/// of the work of MUMPS on its smallest fronts counts as waiting, and times by the clock are longer for it.
double seconds_waited() noexcept;
