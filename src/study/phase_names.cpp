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
  std::vector<std::string> phases = {std::string(name_of_matrix_phase)}, materials;
  const auto add = [&](const Material& material) {
    if (std::ranges::find(materials, material.name) != materials.end()) return;
    materials.push_back(material.name);
    phases.push_back(phase_of(stage, material));
  };
  for (const auto& filler : stage.fillers) {
    if (filler.coating) add(filler.coating->material);
  }
  for (const auto& filler : stage.fillers) add(filler.material);
  return phases;
}

}  // namespace breccia
