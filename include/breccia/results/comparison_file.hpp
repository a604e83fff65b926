#pragma once

#include <filesystem>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Writes `comparison.csv` to a directory if there is something to compare. Throws FileError.
void write_comparisons(const std::filesystem::path& directory, const StudyResult& result);

}  // namespace breccia
