#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// A material of a study, from its `study.json`.
struct StoredMaterial {
  Material material;                           ///< at the temperature of the study
  std::optional<TemperatureShift> shift = {};  ///< shift law and temperature of the study, if the deck has them
};

/// All materials of a study.
struct StoredMaterials {
  std::string deck_hash;  ///< of the study
  std::vector<StoredMaterial> materials;
};

/// Reads the materials from `study.json` in a directory of results. Throws FileError when the file cannot be read or
/// does not have the format of this version.
StoredMaterials read_stored_materials(const std::filesystem::path& directory);

/// The material at another temperature [K]; an elastic material does not change. Throws InputError if the deck has no
/// shift law for the material, or the temperature is outside the range of the law.
Material at_temperature(const StoredMaterial& stored, double temperature);

}  // namespace breccia
