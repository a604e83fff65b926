#pragma once

#include <filesystem>
#include <string>

#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

/// Reads a material from a TOML file with the same keys as a material of a deck. The material is named after the file.
/// Throws InputError with one line for every mistake, and FileError when the file cannot be read.
ShiftedMaterial read_shifted_material_file(const std::filesystem::path& file);

/// A material from text with these keys; files that it names are relative to `directory`, and a line about a mistake
/// begins with the name.
ShiftedMaterial shifted_material_from_text(const std::string& text, const std::string& name,
                                           const std::filesystem::path& directory);

}  // namespace breccia
