#pragma once

#include <filesystem>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// Writes the comparisons of the stages with measurements to a directory: `comparison.csv` with those of the relaxation
/// modulus, and `comparison_dynamic.csv` with those of the complex modulus; no table without rows. Throws FileError.
void write_comparisons(const std::filesystem::path& directory, const StudyResult& result);

}  // namespace breccia
