#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "breccia/campaign/run.hpp"
#include "breccia/study/sweep.hpp"

#include "campaign/result_transaction.hpp"
#include "io/directory_lock.hpp"

namespace breccia {

/// The directory of a sweep, locked as long as this object lives; a single task without a name, which has the directory
/// for itself, locks it by its ResultTransaction instead. The directory of each task is read once.
///
/// All processes of all groups call the constructor and complete_runs(), and a failure of one process is thrown on all
/// of them.
class SweepDirectory {
 public:
  /// Throws ConflictingResults, for all tasks at once, if a study was changed after its deck was read, and if the sweep
  /// would replace or resume results of another study, sweep or version without `overwrite`, or replace files that
  /// Breccia did not write; DirectoryInUse if another process writes to the directory or to that of a task; FileError.
  /// Changes nothing. The sweep must outlive this object.
  SweepDirectory(const Sweep& sweep, std::filesystem::path directory, const RunOptions& options);

  /// The options of each task. With `overwrite` a sweep may replace the results that are in the directories of its
  /// tasks when it begins. A resumed sweep may replace those of them that `sweep.json` still lists, but not later ones.
  [[nodiscard]] const std::vector<RunOptions>& options_of_tasks() const noexcept { return options_; }
  /// The run that has left complete results, for each task (ResultTransaction::take_over).
  [[nodiscard]] std::vector<CompleteRun> complete_runs() const;

 private:
  void open(const RunOptions& options);

  const Sweep& sweep_;
  std::filesystem::path directory_;
  std::optional<DirectoryLock> lock_;  ///< the lock is held by the first process alone
  std::vector<RunOptions> options_;
  std::vector<bool> are_complete_;  ///< whether the results of a task are complete
};

}  // namespace breccia
