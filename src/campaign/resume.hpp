#pragma once

#include <filesystem>
#include <optional>

#include "breccia/campaign/run_observer.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Wall time [s] of the run whose results are in a directory; nothing unless they are complete and belong to this
/// study, its data files and this version of Breccia. Throws FileError when `study.json` cannot be read.
std::optional<double> time_of_complete_run(const Study& study, const std::filesystem::path& directory);

/// As time_of_complete_run(), but if that run was killed after its last test, the function first completes its work: it
/// writes the page and the checksums, and removes checkpoints and half-written files. Returns nothing, and sends a
/// Note, if a file other than the page is missing or has changed since (results/checksums.hpp); the page is written
/// anew. Throws DirectoryInUse if another process writes to the directory.
std::optional<double> take_over_complete_run(const Study& study, const std::filesystem::path& directory,
                                             const RunObserver& observer = {});

/// Whether a directory has results of tests, complete or not.
bool holds_tests(const std::filesystem::path& directory);

}  // namespace breccia
