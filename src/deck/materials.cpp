#include "deck/materials.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/discretisation/crystals.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

#include "assessment/changed_material.hpp"
#include "deck/crystals.hpp"
#include "deck/moduli.hpp"
#include "deck/temperature_shift.hpp"
#include "io/nearest_name.hpp"
#include "io/printable.hpp"
#include "io/units.hpp"
#include "study/limits.hpp"

namespace breccia {

namespace {

/// Multiplies the relaxation times and the moduli of a material that relaxes by the factors of `factors`.
ShiftedMaterial with_factors(const Section& section, const ShiftedMaterial& material) {
  const auto factors = section.optional_section("factors");
  if (!factors) return material;
  MaterialChange change;
  for (const auto number : {MaterialNumber::times, MaterialNumber::modulus}) {
    const auto factor = factors->optional_number(std::string(name_of(number)), Range::positive());
    if (factor && !std::isnan(*factor)) change.numbers[number] = *factor;
  }
  auto multiplied = material;
  section.report_errors_of("factors", [&] { multiplied = changed(material, change); });
  return multiplied;
}

}  // namespace

ShiftedMaterial read_shifted_material(const Section& section, const std::string& name) {
  Material reference = {name, section.quantity("density", Dimension::density, Range::positive()), {}, {}};
  const auto expansion =
      section.optional_quantity("thermal_expansion", Dimension::expansion, allowed::thermal_expansion);
  if (section.has("stiffness")) {
    section.refuse({"bulk", "shear", "young", "poisson", "temperature_shift"},
                   "the stiffness of a crystal gives all of its moduli");
    const auto constants = read_stiffness(section);
    // After a mistake its moduli are unknown; it is a crystal all the same.
    if (!constants) return {.material = reference, .constants = ElasticConstants{}};
    const auto means = isotropic_means(stiffness_tensor(*constants));
    reference.bulk = PronySeries(means.bulk());
    reference.shear = PronySeries(means.shear());
    return {.material = reference, .constants = constants, .thermal_expansion = expansion};
  }
  auto moduli = read_moduli(section);
  reference.bulk = std::move(moduli.bulk);
  reference.shear = std::move(moduli.shear);
  const auto shift = read_temperature_shift(section, moduli.shift_law);
  const ShiftedMaterial material = {
      .material = shift ? shifted(reference, shift_factor(shift->law, shift->temperature)) : reference,
      .shift = shift,
      .thermal_expansion = expansion};
  return with_factors(section, material);
}

std::vector<ShiftedMaterial> read_materials(const Section& deck) {
  const auto section = deck.section("materials");
  std::vector<ShiftedMaterial> materials;
  for (const auto& name : section.keys()) {
    if (!is_printable(name)) section.report(name, "expected a name without line breaks and other control characters");
    if (name == name_of_void) {
      section.report(name, "a void has no moduli: fillers and labels of pixels name it without a table of its own");
      if (section.kind(name) == Kind::table) section.section(name).accept_all_keys();
      continue;
    }
    materials.push_back(read_shifted_material(section.section(name), name));
  }
  return materials;
}

void refuse_crystal(const Section& section, const std::string& key, const Material& means) {
  section.report(
      key, fmt::format("a crystal, which has a stiffness, is expected as a filler alone; elsewhere a material with "
                       "its isotropic means, bulk = \"{}\" and shear = \"{}\"",
                       readable(means.bulk.unrelaxed(), Dimension::pressure),
                       readable(means.shear.unrelaxed(), Dimension::pressure)));
}

Material read_material_reference(const Section& section, const std::string& key,
                                 const std::vector<ShiftedMaterial>& materials) {
  const auto name = section.text(key);
  if (name.empty()) return {};
  if (name == name_of_void) return void_material();
  if (const auto* const found = find_material(materials, name)) {
    if (found->constants) refuse_crystal(section, key, found->material);
    return found->material;
  }
  std::vector<std::string> names;
  names.reserve(materials.size());
  for (const auto& known : materials) names.push_back(known.material.name);
  names.emplace_back(name_of_void);
  section.report(key, fmt::format("unknown material \"{}\"{}", name, suggestion(name, names)));
  return {};
}

}  // namespace breccia
