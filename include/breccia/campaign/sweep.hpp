#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "breccia/campaign/run.hpp"
#include "breccia/deck/sweep.hpp"
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

}  // namespace breccia
