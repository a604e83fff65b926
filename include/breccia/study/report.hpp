#pragma once

#include <filesystem>

namespace breccia {

/// Writes `report.html` to a directory, from the results of a study that are there, complete or not. Throws InputError
/// when there are none, and FileError when one of them cannot be read, is not as this program writes it, or belongs to
/// another study.
void write_report(const std::filesystem::path& directory);

}  // namespace breccia
