#include "results/stored_document.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace breccia {
namespace {

StageContent content_of(const StageEntry& stage) {
  StageContent content{stage.name, stage.matrix, stage.dimensions};
  if (!stage.whole_filler) return content;
  content.shares = stage.whole_filler->materials;
  if (const auto& coatings = stage.whole_filler->coatings) {
    content.shares.insert(content.shares.end(), coatings->begin(), coatings->end());
  }
  if (const auto porosity = stage.whole_filler->porosity) content.shares.push_back({name_of_void, *porosity});
  return content;
}

}  // namespace

std::optional<std::string> note_on_completeness(const std::filesystem::path& directory, const StudyDocument& document) {
  if (document.is_complete) return std::nullopt;
  return fmt::format("{}: the run is not complete: finer grids, other tests or later stages may be missing; resume it",
                     directory.string());
}

std::vector<ShiftedMaterial> materials_of(const StudyDocument& document) {
  std::vector<ShiftedMaterial> materials;
  for (const auto& [name, density, bulk, shear, shift, constants, expansion] : document.materials) {
    auto& material = materials.emplace_back(ShiftedMaterial{{name, density, bulk, shear}, shift});
    material.thermal_expansion = expansion;
    if (constants && constants->size() == ElasticConstants().size()) {
      std::ranges::copy(*constants, material.constants.emplace().begin());
    }
  }
  return materials;
}

StudyContent content_of(const StudyDocument& document) {
  StudyContent content{.title = document.title,
                       .times = document.times,
                       .by_frequency = document.frequencies.has_value(),
                       .materials = materials_of(document)};
  for (const auto& stage : document.stages) content.stages.push_back(content_of(stage));
  return content;
}

}  // namespace breccia
