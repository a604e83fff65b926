#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

/// The names of the files that write_material() may write for a material.
std::vector<std::string> material_files(const std::string& material);

/// Writes a material to a directory as a TOML file with the keys of a material of a deck, which `breccia respond
/// --material` reads, and the series of its moduli that relax as Prony files. It is at the temperature at which it is
/// given. Returns the names of the files, the TOML file first. Throws FileError.
std::vector<std::string> write_material(const std::filesystem::path& directory, const ShiftedMaterial& material,
                                        const std::string& comment);

}  // namespace breccia
