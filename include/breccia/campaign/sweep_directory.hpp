#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "breccia/campaign/run.hpp"
#include "breccia/deck/sweep.hpp"
#include "breccia/io/directory_lock.hpp"

namespace breccia {

/// How each task is run. A sweep that is to overwrite may replace the results that are in the directories of its tasks
/// when it begins, and one that resumes those of them that `sweep.json` still names: not what others put there since.
std::vector<RunOptions> options_of_tasks(const Sweep& sweep, const std::filesystem::path& directory,
                                         const RunOptions& options);

/// Locks the directory of a sweep for as long as what is returned lives, and brings to their ends replacements in the
/// directories of its tasks that were cut off. Returns nullptr in processes but the first, and for a single task
/// without a name, which locks the directory itself. Throws DirectoryInUse where another process writes to one of the
/// directories, and FileError.
std::unique_ptr<DirectoryLock> hold_sweep_directory(const Sweep& sweep, const std::filesystem::path& directory);

/// Throws InputError, for all tasks at once, where a run would replace or go on from results of another study, sweep or
/// version and is not to overwrite them, or replace files that Breccia did not write.
void refuse_objections(const Sweep& sweep, const std::filesystem::path& directory, const RunOptions& options);

}  // namespace breccia
