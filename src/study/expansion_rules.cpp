#include "study/expansion_rules.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "breccia/viscoelasticity/thermal_expansion.hpp"

#include "study/chain.hpp"

namespace breccia {
namespace {

/// The first material of a stage whose expansion the study does not give; empty if all have one. A void needs none.
std::string material_without_expansion(const Study& study, const Stage& stage) {
  for (const auto& material : named_materials(stage)) {
    const auto* known = find_material(study.materials, material.name);
    if (!is_void(material) && (known == nullptr || !known->thermal_expansion)) return material.name;
  }
  return {};
}

}  // namespace

bool asks_for_expansion(const Study& study) {
  return std::ranges::any_of(study.materials,
                             [](const ShiftedMaterial& one) { return one.thermal_expansion.has_value(); });
}

std::optional<std::string> obstacle_to_expansion(const Study& study, const Stage& stage) {
  if (stage.dimensions() == 2) return "a box of two dimensions is one of parallel fibres";
  const auto has_none = material_without_expansion(study, stage);
  if (!has_none.empty()) return fmt::format("{} has no thermal_expansion", has_none);
  if (stage.has_crystals()) return "its grains are crystals, which expand differently along their axes";
  if (stage.bonds) return "some of its films are debonded";
  const auto has_coating = [](const Filler& filler) { return filler.coating.has_value(); };
  const auto is_another = [&stage](const Filler& filler) {
    return filler.material.name != stage.fillers.front().material.name;
  };
  if (std::ranges::any_of(stage.fillers, has_coating) || std::ranges::any_of(stage.fillers, is_another)) {
    return "it has more than two phases";
  }
  const auto* earlier = stage_of_matrix(study, stage);
  if (earlier != nullptr && obstacle_to_expansion(study, *earlier)) {
    return fmt::format("that of its matrix, {}, is not known", earlier->name);
  }
  if (earlier == nullptr && !stage.fillers.empty()) {
    return obstacle_in_moduli(stage.fillers.front().material, std::get<Material>(stage.matrix));
  }
  return std::nullopt;
}

std::optional<std::string> obstacle_in_moduli(const Material& filler, const Material& matrix) {
  if (determines_expansion(filler.bulk, matrix.bulk)) return std::nullopt;
  if (!filler.bulk.is_elastic()) return fmt::format("the bulk modulus of {} relaxes", filler.name);
  return fmt::format(
      "the bulk moduli of {} and {} come within a tenth of each other, so that that of the composite does "
      "not determine it",
      filler.name, matrix.name);
}

}  // namespace breccia
