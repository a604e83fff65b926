#include "homogenisation/varying_phases.hpp"

#include <algorithm>
#include <cstddef>

#include "breccia/homogenisation/stage_discretisation.hpp"

namespace breccia {

std::map<std::string, Material> other_varying_phases(const Tests& tests, const Stage& stage) {
  const auto phases = phases_of(stage);
  // The matrix always counts as a varying phase.
  const auto materials = materials_of(stage, {});
  std::map<std::string, Material> varying;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const auto& material = materials[i];
    const bool varies = !material.bulk.is_elastic() || !material.shear.is_elastic() ||
                        std::ranges::find(tests.varied, material.name, &VariedMaterial::name) != tests.varied.end();
    if (varies && phases.names()[i] != name_of_matrix_phase) varying.emplace(phases.names()[i], material);
  }
  return varying;
}

std::vector<VaryingPhase> varying_phases(const Tests& tests, const Stage& stage) {
  const auto phases = phases_of(stage);
  std::vector<VaryingPhase> varying = {{phases.index_of(name_of_matrix_phase), std::string(name_of_matrix_phase)}};
  for (const auto& [name, material] : other_varying_phases(tests, stage))
    varying.push_back({phases.index_of(name), name});
  return varying;
}

}  // namespace breccia
