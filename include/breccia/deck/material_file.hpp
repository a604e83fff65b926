#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// A material at the temperature in its table, with its temperature shift, if the table has one.
struct ShiftedMaterial {
  Material material;
  std::optional<TemperatureShift> shift;
};

/// Reads a material from a TOML file with the same keys as a material of a deck. The material is named after the file.
/// Throws InputError with one line for every mistake, and FileError when the file cannot be read.
ShiftedMaterial read_shifted_material_file(const std::filesystem::path& file);

/// The same without its temperature shift.
Material read_material_file(const std::filesystem::path& file);

/// The same from text with these keys; files that it names are relative to `directory`, and a line about a mistake
/// begins with the name.
ShiftedMaterial shifted_material_from_text(const std::string& text, const std::string& name,
                                           const std::filesystem::path& directory);

}  // namespace breccia
