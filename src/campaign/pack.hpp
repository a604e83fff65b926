#pragma once

#include <filesystem>

#include "breccia/campaign/run.hpp"

namespace breccia {

class ResultTransaction;

/// Packs the microstructures of a study without running tests, and writes them to a directory together with checkpoints
/// from which run_study() can resume. Throws as run_study().
StudyResult pack_study(const Study& study, const std::filesystem::path& directory, const RunOptions& options = {},
                       const RunObserver& observer = {});

/// As pack_study() above, but in a directory that was opened before.
StudyResult pack_study(ResultTransaction& results, const RunObserver& observer);

}  // namespace breccia
