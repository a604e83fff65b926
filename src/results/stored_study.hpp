#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "breccia/homogenisation/stage_responses.hpp"
#include "breccia/homogenisation/study_result.hpp"

#include "results/composite.hpp"

namespace breccia {

/// The results of a study as its directory has them.
struct StoredStudy {
  StudyContent content = {};
  /// Without fields, the stages as materials, and records of the computation. Of the series there are those of the
  /// preferred tests (is_preferred); those of others are empty.
  std::vector<StageFindings> stages = {};
  std::optional<double> seconds = {};          ///< wall time of the complete study [s]
  std::vector<StageResponses> responses = {};  ///< of the stages that have left some
};

/// Reads `study.json`, the tables of curves and the reduced responses in a directory of results, complete or not.
/// Throws InputError as require_stored_study(), and FileError when a file is not as `breccia run` writes it.
StoredStudy read_stored_study(const std::filesystem::path& directory);

}  // namespace breccia
