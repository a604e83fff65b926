#pragma once

#include <filesystem>

#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Reads a material from a TOML file with the same keys as a material of a deck. The material is named after the file.
/// Throws InputError with one line for every mistake, and FileError when the file cannot be read.
Material read_material_file(const std::filesystem::path& file);

}  // namespace breccia
