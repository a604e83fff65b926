#pragma once

#include <filesystem>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Writes all tests of all stages to a directory: `curves.csv` and `prony.csv`, and where there is something to put in
/// them `compliance.csv`, `extrapolation.csv` and `quality.csv`. Throws FileError.
void write_curves(const std::filesystem::path& directory, const StudyResult& result);

}  // namespace breccia
