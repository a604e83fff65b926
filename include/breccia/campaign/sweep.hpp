#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "breccia/campaign/run.hpp"
#include "breccia/deck/sweep.hpp"
#include "breccia/io/directory_lock.hpp"
#include "breccia/results/sweep_result.hpp"

namespace breccia {

/// Those who follow a sweep. What they throw ends it.
struct SweepObserver {
  std::function<void(std::size_t task)> begun = {};
  std::function<void(std::size_t task)> skipped = {};  ///< complete already
  std::function<void(std::size_t task, const std::string& error)> failed = {};
  RunObserver study = {};  ///< follows each task
};

/// Runs the tasks one after the other, those of each group of processes (parallel::divide) beside the others, each in
/// the directory of its name, and writes `sweep.csv`, `sweep.json`, `sweep.svg` and, where seeds are swept,
/// `spread.csv` (docs/results.md) anew after each of them. A task that fails for its numbers or its microstructure does
/// not end the others. One that resumes leaves alone the tasks that are complete, and goes on with the others from
/// their checkpoints. Throws FileError or Interrupted, DirectoryInUse where another process writes to the directory or
/// to that of a task, and InputError as refuse_objections does.
SweepResult run_sweep(const Sweep& sweep, const std::filesystem::path& directory, const RunOptions& options,
                      const SweepObserver& observer = {});

/// Locks the directory of a sweep for as long as what is returned lives, and brings to their ends replacements in the
/// directories of its tasks that were cut off. Returns nullptr in processes but the first, and for a single task
/// without a name, which locks the directory itself. Throws DirectoryInUse where another process writes to one of the
/// directories, and FileError.
std::unique_ptr<DirectoryLock> hold_sweep_directory(const Sweep& sweep, const std::filesystem::path& directory);

/// Throws InputError, for all tasks at once, where a study was changed after its deck was read, and where a run would
/// replace or go on from results of another study, sweep or version and is not to overwrite them, or replace files that
/// Breccia did not write.
void refuse_objections(const Sweep& sweep, const std::filesystem::path& directory, const RunOptions& options);

}  // namespace breccia
