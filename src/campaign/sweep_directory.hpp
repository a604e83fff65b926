#pragma once

#include <filesystem>
#include <vector>

#include "breccia/campaign/sweep.hpp"

namespace breccia {

/// How each task is run. A sweep that resumes may replace the results of other studies in the directories of those
/// tasks that the tables of the directory name already: the run that began the sweep was to overwrite them.
std::vector<RunOptions> options_of_tasks(const Sweep& sweep, const std::filesystem::path& directory,
                                         const RunOptions& options);

}  // namespace breccia
