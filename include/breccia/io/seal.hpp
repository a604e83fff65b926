#pragma once

#include <filesystem>
#include <string>

#include "breccia/error.hpp"

namespace breccia {

/// Appends to a file a line with a checksum of all bytes above it. Throws FileError.
void seal(const std::filesystem::path& path);

/// Error: the content of a file has changed since it was sealed.
class DamagedFile : public FileError {
 public:
  explicit DamagedFile(const std::string& message) : FileError(message) {}
};

/// Throws DamagedFile when a file does not end with such a line or the checksum does not fit its bytes, and another
/// FileError when it cannot be read.
void require_sealed(const std::filesystem::path& path);

}  // namespace breccia
