#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "breccia/homogenisation/stage_responses.hpp"

namespace breccia {

/// Writes the reduced responses of a stage to `response.h5` in a directory, unless there are none. Throws FileError.
void write_responses(const std::filesystem::path& directory, const StageResponses& responses);

/// Reads the reduced responses of a stage from a file. Throws FileError when it cannot be read or does not have the
/// format of write_responses(), and DamagedFile (io/seal.hpp) when it has changed since it was written.
StageResponses read_responses(const std::filesystem::path& file);

/// A note for the user where a file of responses has no checksum, like those of older versions. Throws FileError.
std::optional<std::string> note_on_responses(const std::filesystem::path& file);

}  // namespace breccia
