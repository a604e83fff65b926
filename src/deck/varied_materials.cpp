#include "deck/varied_materials.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace breccia {
namespace {

/// Reads two rising moduli [Pa] from a key; nothing without the key, or after a mistake was reported.
std::optional<ModulusInterval> read_interval(const Section& material, const std::string& key) {
  if (!material.has(key)) return std::nullopt;
  const auto moduli = material.quantities(key, Dimension::pressure, Range::positive());
  // An invalid modulus has been reported already and is NaN here.
  if (moduli.empty() || std::ranges::any_of(moduli, [](double one) { return std::isnan(one); })) return std::nullopt;
  if (moduli.size() == 2 && moduli[0] < moduli[1]) return ModulusInterval{moduli[0], moduli[1]};
  material.report(key, R"(expected two rising moduli, such as ["10 MPa", "1 GPa"])");
  return std::nullopt;
}

}  // namespace

std::vector<VariedMaterial> read_varied_materials(const Section& quasistatic, const std::vector<Stage>& stages) {
  const auto section = quasistatic.optional_section("vary");
  if (!section) return {};
  std::vector<VariedMaterial> varied;
  for (const auto& name : section->keys()) {
    const auto material = section->section(name);
    const VariedMaterial one = {name, read_interval(material, "shear"), read_interval(material, "bulk")};
    const bool has_mistakes =
        one.shear.has_value() != material.has("shear") || one.bulk.has_value() != material.has("bulk");
    if (!has_mistakes) {
      for (const auto& mistake : mistakes_of_varied(one, stages)) section->report(name, mistake);
    }
    varied.push_back(one);
  }
  return varied;
}

}  // namespace breccia
