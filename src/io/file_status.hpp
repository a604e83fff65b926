#pragma once

#include <filesystem>

namespace breccia {

/// The status of a path: a file, a directory, or nothing; symbolic links are followed. Throws FileError where the
/// system returns an error, as in a directory that may not be read, or for a link that leads to itself.
[[nodiscard]] std::filesystem::file_status status_of(const std::filesystem::path& path);

}  // namespace breccia
