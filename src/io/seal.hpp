#pragma once

#include <filesystem>
#include <string>

#include "breccia/error.hpp"

namespace breccia {

/// The content_hash() of the bytes of a file. Throws FileError.
std::string content_hash_of(const std::filesystem::path& path);

/// Appends to a file a line with a checksum of all bytes above it. Throws FileError.
void seal(const std::filesystem::path& path);

/// The text with the line that seal() would append.
std::string sealed(std::string text);

/// Error: the content of a file has changed since it was sealed.
class DamagedFile : public FileError {
 public:
  explicit DamagedFile(const std::string& message) : FileError(message) {}
};

/// Whether a file ends with the line of seal(). Throws FileError when it cannot be read.
bool is_sealed(const std::filesystem::path& path);

/// Throws DamagedFile when a file does not end with the line of seal() or the checksum does not fit its bytes, and
/// another FileError when it cannot be read.
void require_sealed(const std::filesystem::path& path);

}  // namespace breccia
