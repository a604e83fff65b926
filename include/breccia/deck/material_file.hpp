#pragma once

#include <filesystem>

#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Reads a material from a TOML file with the keys of a material in a deck; its name is that of the file. Throws
/// InputError with one line for every mistake, and FileError when the file cannot be read.
Material read_material_file(const std::filesystem::path& file);

}  // namespace breccia
