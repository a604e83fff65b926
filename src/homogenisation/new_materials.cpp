#include "breccia/homogenisation/new_materials.hpp"

#include <algorithm>
#include <set>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/io/nearest_name.hpp"
#include "breccia/io/units.hpp"
#include "breccia/study/phase_names.hpp"

namespace breccia {
namespace {

/// The materials that a name stands for: one for the name of a material, one or several for that of a phase.
using MaterialsByName = std::map<std::string, std::set<std::string>>;

MaterialsByName materials_by_name(const std::vector<StoredResponses>& stored) {
  MaterialsByName by_name;
  for (const auto& one : stored) {
    if (std::holds_alternative<Material>(one.matrix)) {
      by_name[std::string(name_of_matrix_phase)].insert(name_of(one.matrix));
    }
    for (const auto& [phase, material] : one.other_phases) by_name[phase].insert(material.name);
  }
  // A name that is that of a material and of a phase means the material.
  for (const auto& material : varying_materials(stored)) by_name[material] = {material};
  return by_name;
}

/// What to do about an elastic material whose moduli were not sampled.
std::string advice_on(const Material& material) {
  constexpr double factor = 10.0;
  const double shear = material.shear.equilibrium();
  return fmt::format(
      "its phase is elastic, and the run has sampled no other moduli of it; write tests.quasistatic.vary = {{ \"{}\" = "
      "{{ shear = [\"{}\", \"{}\"] }} }} (or other moduli, bulk too) into the deck and run it",
      material.name, readable(shear / factor, Dimension::pressure), readable(shear * factor, Dimension::pressure));
}

std::string mistake_of_unknown(const std::string& name, const MaterialsByName& known,
                               const std::vector<Material>& of_study) {
  const auto material = std::ranges::find(of_study, name, &Material::name);
  if (material != of_study.end()) return fmt::format("{} does not vary: {}", name, advice_on(*material));
  if (name == name_of_filler_phase) {
    return "the fillers do not vary: they are elastic, and the run has sampled no other moduli of them; write the name "
           "of their material under tests.quasistatic.vary into the deck and run it";
  }
  std::vector<std::string> names;
  for (const auto& [one, materials] : known) names.push_back(one);
  return fmt::format("no material or phase \"{}\" varies{}", name, suggestion(name, names));
}

}  // namespace

std::vector<std::string> varying_materials(const std::vector<StoredResponses>& stored) {
  std::vector<std::string> names;
  for (const auto& one : stored) {
    if (std::holds_alternative<Material>(one.matrix)) names.push_back(name_of(one.matrix));
    for (const auto& [phase, material] : one.other_phases) names.push_back(material.name);
  }
  return names;
}

std::map<std::string, Material> by_replaced_material(const std::vector<NewMaterial>& new_materials,
                                                     const std::vector<StoredResponses>& stored,
                                                     const std::vector<Material>& of_study) {
  require_earlier_stages(stored);
  const auto known = materials_by_name(stored);
  std::map<std::string, Material> replacements;
  std::vector<std::string> mistakes;
  bool is_elastic = false;  // a material that no other moduli were sampled of
  for (const auto& [name, material] : new_materials) {
    const auto found = known.find(name);
    if (found == known.end()) {
      is_elastic = is_elastic || name == name_of_filler_phase ||
                   std::ranges::find(of_study, name, &Material::name) != of_study.end();
      mistakes.push_back(mistake_of_unknown(name, known, of_study));
    } else if (found->second.size() > 1) {
      mistakes.push_back(fmt::format("{} stands for several materials of the stages, {}; give the name of one", name,
                                     fmt::join(found->second, ", ")));
    } else if (const auto& replaced = *found->second.begin(); !replacements.emplace(replaced, material).second) {
      mistakes.push_back(
          fmt::format("{} is given twice{}", replaced, name == replaced ? "" : fmt::format(" (also as {})", name)));
    }
  }
  if (mistakes.empty()) return replacements;
  const auto message = fmt::format("{}", fmt::join(mistakes, "\n"));
  if (is_elastic) throw NotVaried(message);
  throw InputError(message);
}

}  // namespace breccia
