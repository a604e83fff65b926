#pragma once

#include <filesystem>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/results/frequency_rows.hpp"

namespace breccia {

/// Writes shear, bulk and Young's modulus and Poisson's ratio of the stages that were tested in shear and in bulk under
/// the same boundary condition and by the same method: `engineering.csv` against time and `engineering_dynamic.csv`
/// against angular frequency, at the times of the curves and the frequencies of `rows`. No files where there is no such
/// stage. Throws FileError.
void write_engineering_tables(const std::filesystem::path& directory, const StudyResult& result,
                              const FrequencyRows& rows);

}  // namespace breccia
