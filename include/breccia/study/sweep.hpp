#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "breccia/io/deck_setting.hpp"
#include "breccia/io/directory_lock.hpp"
#include "breccia/study/run.hpp"

namespace breccia {

/// A key of a deck that takes several values.
struct SweptKey {
  std::string path;      ///< as in `--set`: `stages.*.packing.seed`
  std::string label;     ///< the last steps of it, as many as tell the keys apart
  bool is_seed = false;  ///< its values are samples of the same
};

/// A deck with one value for each swept key.
struct SweepTask {
  std::string name;                 ///< also that of its directory: `volumetric-averaged_seed-2`
  std::vector<std::string> labels;  ///< of each key with its value: the parts of the name
  std::vector<Scalar> values;       ///< of the keys
  Study study;

  /// Where its results go in a directory: the directory itself without a name.
  [[nodiscard]] std::filesystem::path directory_in(const std::filesystem::path& results) const {
    return name.empty() ? results : results / name;
  }
};

/// All combinations of the values of some keys, the last key running fastest. Without keys it is a single task, which
/// has no name.
struct Sweep {
  std::vector<SweptKey> keys;
  std::vector<SweepTask> tasks;
};

/// Reads a deck with overrides as read_study does, with its `[sweep]` and further keys `key.path=[value, ...]`. Throws
/// InputError with one line for every mistake in any task, and FileError.
Sweep read_sweep(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                 const std::vector<std::string>& further_keys);

/// A curve of a task.
struct TaskCurve {
  std::string stage, load, boundary, method, cells;  ///< as in curves.csv
  Curve modulus;

  /// Are both of the same test?
  [[nodiscard]] bool matches(const TaskCurve& other) const;
};

enum class TaskState { waiting, done, failed };

/// What became of a task.
struct TaskResult {
  TaskState state = TaskState::waiting;
  std::vector<TaskCurve> curves = {};  ///< when it is done
  double seconds = 0.0;                ///< wall time of the run that has done it
  std::string error = {};              ///< why it has failed
};

/// In the order of the sweep's tasks.
using SweepResult = std::vector<TaskResult>;

/// Those who follow a sweep. What they throw ends it.
struct SweepObserver {
  std::function<void(std::size_t task)> begun = {};
  std::function<void(std::size_t task)> skipped = {};  ///< complete already
  std::function<void(std::size_t task, const std::string& error)> failed = {};
  StudyObserver study = {};  ///< follows each task
};

/// Runs the tasks one after the other, those of each group of processes (parallel::divide) beside the others, each in
/// the directory of its name, and writes `sweep.csv`, `sweep.json`, `sweep.svg` and, where seeds are swept,
/// `spread.csv` (docs/results.md) anew after each of them. A task that fails for its numbers or its microstructure does
/// not end the others. One that resumes leaves alone the tasks that are complete, and goes on with the others from
/// their checkpoints. Throws FileError or Interrupted, DirectoryInUse where another process writes to the directory or
/// to that of a task, and InputError as refuse_objections does.
SweepResult run_sweep(const Sweep& sweep, const std::filesystem::path& directory, const RunOptions& options,
                      const SweepObserver& observer = {});

/// The moduli of tasks that differ in their seeds alone, at one time of one test.
struct Spread {
  double time = 0.0;                ///< [s]
  std::size_t tasks = 0;            ///< two or more
  double mean = 0.0;                ///< [Pa]
  double standard_deviation = 0.0;  ///< of a sample, with n - 1 [Pa]
  double smallest = 0.0;            ///< [Pa]
  double largest = 0.0;             ///< [Pa]
};

/// The spread of a test over the seeds.
struct SpreadCurve {
  std::size_t first_task = 0;  ///< of those that differ in their seeds alone
  TaskCurve test;              ///< without its curve
  std::vector<Spread> spreads;
};

/// The spread of every test over the seeds, for each combination of the other keys; times that a single task has are
/// left out.
std::vector<SpreadCurve> spread_over_seeds(const Sweep& sweep, const SweepResult& result);

/// The parts of the name of a task that do not tell its seeds; empty when there are no others.
std::string name_without_seeds(const Sweep& sweep, const SweepTask& task);

/// The names of the stages that the tasks have tested, in their order.
std::vector<std::string> tested_stages(const SweepResult& result);

/// The results with but one curve for each boundary of a stage: of shear if it was tested, of several grids the
/// extrapolated or else the finest, and of both methods the quasi-static.
SweepResult stage_of(const SweepResult& result, const std::string& stage);

/// That of the last stage of each task.
SweepResult last_stage_of(const SweepResult& result);

/// "upper bound", "lower bound" or "periodic".
std::string bound_of(const TaskCurve& curve);

/// Locks the directory of a sweep for as long as what is returned lives, and brings to their ends replacements in the
/// directories of its tasks that were cut off. Returns nullptr in processes but the first, and for a single task
/// without a name, which locks the directory itself. Throws DirectoryInUse where another process writes to one of the
/// directories, and FileError.
std::unique_ptr<DirectoryLock> hold_sweep_directory(const Sweep& sweep, const std::filesystem::path& directory);

/// Throws InputError, for all tasks at once, where a run would replace or go on from results of another study, sweep or
/// version and is not to overwrite them, or replace files that Breccia did not write.
void refuse_objections(const Sweep& sweep, const std::filesystem::path& directory, const RunOptions& options);

}  // namespace breccia
