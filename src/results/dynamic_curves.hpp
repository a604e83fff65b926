#pragma once

#include <filesystem>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/results/frequency_rows.hpp"

namespace breccia {

/// Writes the storage and loss moduli of the series of prony.csv, at the frequencies of `rows`. Writes no file if there
/// is no series. Throws FileError.
void write_dynamic_curves(const std::filesystem::path& file, const StudyResult& result, const FrequencyRows& rows);

}  // namespace breccia
