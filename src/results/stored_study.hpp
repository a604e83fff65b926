#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "breccia/homogenisation/stage_responses.hpp"
#include "breccia/homogenisation/study_result.hpp"

#include "results/composite.hpp"

namespace breccia {

/// The results of a study, read from its directory.
struct StoredStudy {
  StudyContent content = {};
  /// The results of the stages, without fields, the stages as materials, and records of the computation. Only the
  /// preferred tests (is_preferred) have series; those of other tests are empty.
  std::vector<StageFindings> stages = {};
  std::optional<double> seconds = {};          ///< wall time of the complete study [s]
  std::vector<StageResponses> responses = {};  ///< responses of the stages that have stored some
};

/// Reads `study.json`, the tables of curves and the reduced responses in a directory of results, complete or not.
/// Throws InputError as require_stored_study(), and FileError when a file is not as `breccia run` writes it.
StoredStudy read_stored_study(const std::filesystem::path& directory);

}  // namespace breccia
