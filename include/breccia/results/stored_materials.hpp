#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// A material of a study, as its `study.json` tells it.
struct StoredMaterial {
  Material material;                           ///< at the temperature of the study
  std::optional<TemperatureShift> shift = {};  ///< the law, and that temperature, where the deck has them
};

struct StoredMaterials {
  std::string deck_hash;  ///< of the study
  std::vector<StoredMaterial> materials;
};

/// Reads `study.json` in a directory of results. Throws FileError where it cannot be read or is not one of this
/// program.
StoredMaterials read_stored_materials(const std::filesystem::path& directory);

/// The material at another temperature [K]; one that does not relax is the same at all. Throws InputError where the
/// deck had no law for it, or the temperature is out of the law.
Material at_temperature(const StoredMaterial& stored, double temperature);

}  // namespace breccia
