#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace breccia {

/// Writes `checksums.txt` to the directory of a study that is complete: a line with the hash (xxHash, 64 bits) and the
/// name of each result file there and in the directories of its stages, as xxhsum reads them, and a seal (io/seal.hpp).
/// Throws FileError.
void write_checksums(const std::filesystem::path& directory, const std::vector<std::string>& stages);

/// The names of the files that are missing or have other bytes than when `checksums.txt` was written, and the name of
/// that file itself if it was changed; nothing if it does not exist. Throws FileError where a file cannot be read.
std::optional<std::vector<std::string>> damaged_files(const std::filesystem::path& directory);

/// The names of the files that have the same bytes as when `checksums.txt` was written, including that file; none if it
/// is missing or was changed itself. Throws FileError where a file cannot be read.
std::vector<std::string> unchanged_files(const std::filesystem::path& directory);

}  // namespace breccia
