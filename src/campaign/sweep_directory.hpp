#pragma once

#include <filesystem>
#include <vector>

#include "breccia/campaign/sweep.hpp"

namespace breccia {

/// The options of each task. With `overwrite` a sweep may replace the results that are in the directories of its tasks
/// when it begins. A resumed sweep may replace those of them that `sweep.json` still lists, but not later ones.
std::vector<RunOptions> options_of_tasks(const Sweep& sweep, const std::filesystem::path& directory,
                                         const RunOptions& options);

}  // namespace breccia
