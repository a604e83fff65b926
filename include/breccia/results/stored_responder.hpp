#pragma once

#include <filesystem>

#include "breccia/homogenisation/responder.hpp"

namespace breccia {

/// The responder of a study whose results are in a directory: the reduced responses of its stages, in the order of the
/// study, with the materials and the warnings of `study.json`. Throws InputError where no stage has stored responses,
/// or some belong to another study, and FileError when a file is not as `breccia run` writes it.
Responder read_responder(const std::filesystem::path& directory);

}  // namespace breccia
