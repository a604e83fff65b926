#pragma once

#include <filesystem>
#include <vector>

#include "breccia/campaign/sweep.hpp"

namespace breccia {

/// How each task is run. A sweep that is to overwrite may replace the results that are in the directories of its tasks
/// when it begins, and one that resumes those of them that `sweep.json` still names: not what others put there since.
std::vector<RunOptions> options_of_tasks(const Sweep& sweep, const std::filesystem::path& directory,
                                         const RunOptions& options);

}  // namespace breccia
