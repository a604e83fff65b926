#include "homogenisation/respond/replaced_materials.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/study/phase_names.hpp"

#include "homogenisation/respond/responded_stages.hpp"
#include "io/nearest_name.hpp"
#include "io/units.hpp"

namespace breccia {
namespace {

/// The materials that a name stands for: one for the name of a material, one or several for that of a phase.
using MaterialsByName = std::map<std::string, std::set<std::string>>;

MaterialsByName materials_by_name(const std::vector<StageResponses>& stages) {
  MaterialsByName by_name;
  for (const auto& one : stages) {
    if (std::holds_alternative<Material>(one.matrix)) {
      by_name[std::string(name_of_matrix_phase)].insert(name_of(one.matrix));
    }
    for (const auto& [phase, material] : one.other_phases) by_name[phase].insert(material.name);
  }
  // A name that a material and a phase share means the material.
  for (const auto& material : varying_materials(stages)) by_name[material] = {material};
  return by_name;
}

/// Advice about an elastic material whose moduli were not sampled.
std::string advice_on(const Material& material) {
  constexpr double factor = 10.0;
  const double shear = material.shear.equilibrium();
  return fmt::format(
      "its phase is elastic, and the run has sampled no other moduli of it; write tests.quasistatic.vary = {{ \"{}\" = "
      "{{ shear = [\"{}\", \"{}\"] }} }} (or other moduli, bulk too) into the deck and run it",
      material.name, readable(shear / factor, Dimension::pressure), readable(shear * factor, Dimension::pressure));
}

std::string mistake_of_unknown(const std::string& name, const MaterialsByName& known, const ShiftedMaterial* elastic) {
  if (elastic != nullptr && elastic->constants) {
    return fmt::format(
        "{} does not vary: it is a crystal, whose constants are those of the run; change them in the deck "
        "and run it",
        name);
  }
  if (elastic != nullptr) return fmt::format("{} does not vary: {}", name, advice_on(elastic->material));
  if (name == name_of_filler_phase) {
    return "the fillers do not vary: they are elastic, and the run has sampled no other moduli of them; write the name "
           "of their material under tests.quasistatic.vary into the deck and run it";
  }
  std::vector<std::string> names;
  for (const auto& [one, materials] : known) names.push_back(one);
  return fmt::format("no material or phase \"{}\" varies{}", name, suggestion(name, names));
}

}  // namespace

std::vector<std::string> replaced_materials(const std::vector<NewMaterial>& new_materials,
                                            const std::vector<StageResponses>& stages,
                                            const std::vector<ShiftedMaterial>& of_study) {
  require_earlier_stages(stages);
  const auto known = materials_by_name(stages);
  std::vector<std::string> replaced, mistakes;
  bool is_elastic = false;  // whether a material is elastic and only its own moduli were sampled
  for (const auto& [name, material, shift] : new_materials) {
    const auto found = known.find(name);
    if (found == known.end()) {
      const auto* const elastic = find_material(of_study, name);
      is_elastic = is_elastic || name == name_of_filler_phase || elastic != nullptr;
      mistakes.push_back(mistake_of_unknown(name, known, elastic));
    } else if (found->second.size() > 1) {
      mistakes.push_back(fmt::format("{} stands for several materials of the stages, {}; give the name of one", name,
                                     fmt::join(found->second, ", ")));
    } else {
      const auto& one = *found->second.begin();
      if (std::ranges::find(replaced, one) != replaced.end()) {
        mistakes.push_back(
            fmt::format("{} is given twice{}", one, name == one ? "" : fmt::format(" (also as {})", name)));
      }
      replaced.push_back(one);
    }
  }
  if (mistakes.empty()) return replaced;
  const auto message = fmt::format("{}", fmt::join(mistakes, "\n"));
  if (is_elastic) throw NotVaried(message);
  throw InputError(message);
}

}  // namespace breccia
