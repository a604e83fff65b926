#include "results/stored_materials.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "results/stored_document.hpp"

namespace breccia {

StoredMaterials read_stored_materials(const std::filesystem::path& directory) {
  const auto document = read_study_document(directory);
  StoredMaterials stored{document.hash, materials_of(document)};
  for (const auto& stage : document.stages) stored.warnings[stage.name] = stage.warnings;
  return stored;
}

}  // namespace breccia
