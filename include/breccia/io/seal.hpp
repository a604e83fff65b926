#pragma once

#include <filesystem>
#include <string>

#include "breccia/error.hpp"

namespace breccia {

/// Puts a line with a checksum of all bytes before it at the end of a file. Throws FileError.
void seal(const std::filesystem::path& path);

/// A file whose bytes are not those that were written.
class DamagedFile : public FileError {
 public:
  explicit DamagedFile(const std::string& message) : FileError(message) {}
};

/// Throws DamagedFile when a file does not end with such a line, or when its bytes are not those that were sealed;
/// another FileError when it cannot be read.
void require_sealed(const std::filesystem::path& path);

}  // namespace breccia
