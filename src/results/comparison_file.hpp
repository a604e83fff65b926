#pragma once

#include <filesystem>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Writes `comparison.csv` to a directory if a stage was compared with a measurement. Throws FileError.
void write_comparisons(const std::filesystem::path& directory, const StudyResult& result);

}  // namespace breccia
