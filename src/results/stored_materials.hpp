#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

/// What `study.json` has for the responses of a study: its materials, and the warnings of its stages.
struct StoredMaterials {
  std::string deck_hash;  ///< of the study
  std::vector<ShiftedMaterial> materials;
  std::map<std::string, std::vector<std::string>> warnings = {};  ///< by the names of the stages
};

/// Reads them from `study.json` in a directory of results. Throws FileError when the file cannot be read or
/// does not have the format of this version.
StoredMaterials read_stored_materials(const std::filesystem::path& directory);

}  // namespace breccia
