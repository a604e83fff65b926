#pragma once

#include <filesystem>

namespace breccia {

/// Writes `report.html` of a study to the directory of its results, from the files that are there; they may be
/// incomplete. Throws FileError when one of them cannot be read, does not have the format of this version, or belongs
/// to another study.
void write_study_report(const std::filesystem::path& directory);

/// Writes `report.html` of a sweep, in the same way.
void write_sweep_report(const std::filesystem::path& directory);

/// Writes `report.html` of the sweep, or else the study, whose results are in a directory. Throws FileError as above,
/// and InputError if the directory has no results.
void write_report(const std::filesystem::path& directory);

}  // namespace breccia
