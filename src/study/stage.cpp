#include "breccia/study/stage.hpp"

#include <algorithm>

namespace breccia {

const std::string& name_of(const StageMatrix& matrix) {
  return std::visit([](const auto& named) -> const std::string& { return named.name; }, matrix);
}

std::vector<int> Stage::grids() const {
  auto grids = coarser_cells;
  grids.push_back(cells);
  return grids;
}

std::vector<Material> named_materials(const Stage& stage) {
  std::vector<Material> materials;
  if (const auto* matrix = std::get_if<Material>(&stage.matrix)) materials.push_back(*matrix);
  const auto add = [&materials](const Material& material) {
    if (std::ranges::find(materials, material.name, &Material::name) == materials.end()) materials.push_back(material);
  };
  for (const auto& filler : stage.fillers) {
    add(filler.material);
    if (filler.coating) add(filler.coating->material);
  }
  return materials;
}

}  // namespace breccia
