#pragma once

#include <filesystem>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Writes `study.json` to a directory: the settings of the study and a record of how each result was computed. Throws
/// FileError.
void write_provenance(const std::filesystem::path& directory, const Study& study, const StudyResult& result);

}  // namespace breccia
