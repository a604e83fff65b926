#pragma once

#include <filesystem>

namespace breccia {

/// Puts a line with a checksum of all bytes before it at the end of a file, and waits until the disk has it.
/// Throws FileError.
void seal(const std::filesystem::path& path);

/// Throws FileError when a file does not end with such a line, or when its bytes are not those that were sealed.
void require_sealed(const std::filesystem::path& path);

}  // namespace breccia
