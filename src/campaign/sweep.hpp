#pragma once

#include <filesystem>

#include "breccia/campaign/run.hpp"
#include "breccia/study/sweep.hpp"

#include "results/sweep_result.hpp"

namespace breccia {

/// Runs the tasks of a sweep, each in the directory of its name. Each group of processes (parallel::divide) runs its
/// tasks one after the other. After each task it rewrites `sweep.csv`, `sweep.json`, `sweep.svg` and, if seeds are
/// swept, `spread.csv` (docs/results.md). If a task fails with NumericalError or InputError, the other tasks still run.
/// With `resume`, complete tasks are skipped, and the remaining ones resume from their checkpoints. Throws FileError,
/// Interrupted, DirectoryInUse if another process writes to the directory or to that of a task, and InputError as the
/// constructor of SweepDirectory.
SweepResult run_sweep(const Sweep& sweep, const std::filesystem::path& directory, const RunOptions& options,
                      const RunObserver& observer = {});

}  // namespace breccia
