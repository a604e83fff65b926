#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "breccia/campaign/run.hpp"
#include "breccia/deck/sweep.hpp"

#include "io/directory_lock.hpp"

namespace breccia {

/// The options of each task. With `overwrite` a sweep may replace the results that are in the directories of its tasks
/// when it begins. A resumed sweep may replace those of them that `sweep.json` still lists, but not later ones.
std::vector<RunOptions> options_of_tasks(const Sweep& sweep, const std::filesystem::path& directory,
                                         const RunOptions& options);

/// Locks the directory of a sweep during the lifetime of the returned object. Returns nullptr on all processes but the
/// first, and for a single task without a name, which locks the directory itself. Throws DirectoryInUse if another
/// process writes to it or to the directory of a task, and FileError.
std::unique_ptr<DirectoryLock> hold_sweep_directory(const Sweep& sweep, const std::filesystem::path& directory);

/// Throws ConflictingResults, for all tasks at once, if a study was changed after its deck was read, and if the sweep
/// would replace or resume results of another study, sweep or version without `overwrite`, or replace files that
/// Breccia did not write.
void refuse_conflicts(const Sweep& sweep, const std::filesystem::path& directory, const RunOptions& options);

}  // namespace breccia
