#pragma once

#include <filesystem>

namespace breccia::cli {

/// The path of the program. Throws FileError if the system does not know it.
std::filesystem::path program_path();

/// The directory of the decks that came with the program. Throws FileError if it is missing.
std::filesystem::path installed_examples();

/// The directory of the documentation that came with the program. Throws FileError if it is missing.
std::filesystem::path installed_documentation();

}  // namespace breccia::cli
