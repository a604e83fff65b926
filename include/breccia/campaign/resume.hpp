#pragma once

#include <filesystem>
#include <optional>

#include "breccia/study/study.hpp"

namespace breccia {

/// Wall time [s] of the run that left its results in a directory, if they are complete, and of this study, its data
/// files and this version of Breccia. Throws FileError when `study.json` cannot be read.
std::optional<double> time_of_complete_run(const Study& study, const std::filesystem::path& directory);

/// The same, and does for a run that was killed at its very end what was left: its page, and the checkpoints and
/// half-written files. Nobody else may be at work in the directory.
std::optional<double> take_over_complete_run(const Study& study, const std::filesystem::path& directory);

/// Whether an earlier run has left results of tests, complete or not, in a directory.
bool holds_tests(const std::filesystem::path& directory);

}  // namespace breccia
