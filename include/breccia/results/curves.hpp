#pragma once

#include <filesystem>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/results/frequency_rows.hpp"

namespace breccia {

/// Writes the curves of all tests of all stages to a directory: `curves.csv` and `prony.csv`, and, unless they would be
/// empty, `compliance.csv`, `dynamic.csv`, `engineering.csv`, `engineering_dynamic.csv`, `extrapolation.csv` and
/// `quality.csv`. The dynamic moduli are at the frequencies of `rows`. Throws FileError.
void write_curves(const std::filesystem::path& directory, const StudyResult& result, const FrequencyRows& rows = {});

}  // namespace breccia
