#pragma once

#include <filesystem>

#include "breccia/campaign/run.hpp"

namespace breccia {

/// Packs the microstructures of a study alone and writes them, and checkpoints from which run_study goes on. Throws as
/// run_study does.
StudyResult pack_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options = {},
                       const RunObserver& observer = {});

}  // namespace breccia
