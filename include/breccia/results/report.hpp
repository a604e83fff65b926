#pragma once

#include <filesystem>

namespace breccia {

/// Each writes `report.html` to a directory, from the results that are there, complete or not, and throws FileError
/// when one of them cannot be read, is not as this program writes it, or belongs to another study.

/// Of a study.
void write_study_report(const std::filesystem::path& directory);

/// Of a sweep.
void write_sweep_report(const std::filesystem::path& directory);

/// Of the sweep or else the study whose results are there. Throws InputError where there are none.
void write_report(const std::filesystem::path& directory);

}  // namespace breccia
