#include "breccia/study/phase_names.hpp"

#include <algorithm>

#include "breccia/quasistatic/reduced_response.hpp"

namespace breccia {
namespace {

/// The different materials of the fillers, by name.
std::vector<std::string> filler_materials(const Stage& stage) {
  std::vector<std::string> names;
  for (const auto& filler : stage.fillers) {
    if (std::ranges::find(names, filler.material.name) == names.end()) names.push_back(filler.material.name);
  }
  return names;
}

}  // namespace

std::string phase_of(const Stage& stage, const Material& material) {
  const auto fillers = filler_materials(stage);
  return fillers == std::vector{material.name} ? std::string(name_of_filler_phase) : material.name;
}

std::vector<std::string> phase_names(const Stage& stage) {
  std::vector<std::string> phases = {std::string(name_of_matrix_phase)};
  auto materials = filler_materials(stage);
  if (materials.size() == 1) {
    phases.emplace_back(name_of_filler_phase);
  } else {
    phases.insert(phases.end(), materials.begin(), materials.end());
  }
  for (const auto& filler : stage.fillers) {
    if (!filler.coating || std::ranges::find(materials, filler.coating->material.name) != materials.end()) continue;
    materials.push_back(filler.coating->material.name);
    phases.push_back(filler.coating->material.name);
  }
  return phases;
}

}  // namespace breccia
