#pragma once

#include <filesystem>

namespace breccia {

/// Writes `report.html` anew to a directory, from the results of the sweep, or else of the study, that are there.
/// Throws InputError where there are none, DirectoryInUse where another process writes to the directory, and FileError
/// when one of the results cannot be read, is not as this program writes it, or belongs to another study.
void write_report(const std::filesystem::path& directory);

}  // namespace breccia
