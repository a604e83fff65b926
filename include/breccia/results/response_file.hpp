#pragma once

#include <filesystem>

#include "breccia/homogenisation/respond.hpp"

namespace breccia {

/// Writes the reduced responses of a stage to `response.h5` in a directory, unless there are none. Throws FileError.
void write_responses(const std::filesystem::path& directory, const StoredResponses& responses);

/// Reads such a file. Throws FileError when it cannot be read or does not have this format.
StoredResponses read_responses(const std::filesystem::path& file);

}  // namespace breccia
