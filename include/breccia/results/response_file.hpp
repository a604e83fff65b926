#pragma once

#include <filesystem>

#include "breccia/homogenisation/respond.hpp"

namespace breccia {

/// Writes the reduced responses of a stage to `response.h5` in a directory; no file where there is no entry. Throws
/// FileError.
void write_responses(const std::filesystem::path& directory, const StoredResponses& responses);

/// Reads such a file. Throws FileError when it cannot be read or is not one of these.
StoredResponses read_responses(const std::filesystem::path& file);

}  // namespace breccia
