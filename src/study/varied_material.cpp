#include "breccia/study/varied_material.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

#include <fmt/format.h>

#include "io/nearest_name.hpp"
#include "io/units.hpp"

namespace breccia {
namespace {

/// Moduli [Pa] over an interval, equally spaced in their logarithm, from the largest to the smallest.
std::vector<double> moduli_over(const ModulusInterval& interval, double per_decade) {
  const double decades = std::log10(interval.most / interval.least);
  const int count = std::max(1, static_cast<int>(std::ceil(per_decade * decades)));
  std::vector<double> moduli = {interval.most};
  for (int i = 1; i < count; ++i) moduli.push_back(interval.most * std::pow(10.0, -decades * i / count));
  moduli.push_back(interval.least);
  return moduli;
}

/// The material with moduli over its intervals, or with all others that it may be, from stiff to soft.
std::vector<Material> samples_of(const VariedMaterial& varied, const Material& material) {
  if (!varied.others.empty()) {
    auto all = varied.others;
    all.push_back(material);
    std::ranges::stable_sort(all, std::ranges::greater(), [](const Material& one) { return one.shear.unrelaxed(); });
    return all;
  }
  // The modulus of a composite is a smooth function of the logarithms of the moduli of its phases, and the bulk modulus
  // of a phase has less influence than its shear modulus.
  constexpr double shear_per_decade = 3.0, bulk_per_decade = 1.0;
  auto shear = std::vector{material.shear.equilibrium()}, bulk = std::vector{material.bulk.equilibrium()};
  if (varied.shear) shear = moduli_over(*varied.shear, shear_per_decade);
  if (varied.bulk) bulk = moduli_over(*varied.bulk, bulk_per_decade);
  std::vector<Material> samples;
  for (const double g : shear) {
    for (const double k : bulk) samples.push_back({material.name, material.density, PronySeries(k), PronySeries(g)});
  }
  return samples;
}

/// The mistakes in an interval in which the modulus of the material should lie.
std::vector<std::string> mistakes_of_interval(const ModulusInterval& interval, const PronySeries& modulus,
                                              std::string_view name) {
  const auto pascals = [](double value) { return readable(value, Dimension::pressure); };
  if (!(interval.least > 0.0) || !(interval.least < interval.most) || !std::isfinite(interval.most)) {
    return {fmt::format("expected two rising positive {} moduli, got {} and {}", name, pascals(interval.least),
                        pascals(interval.most))};
  }
  constexpr double most_decades = 6.0;
  if (std::log10(interval.most / interval.least) > most_decades) {
    return {fmt::format("expected {} moduli at most {:g} decades apart, got {} and {}", name, most_decades,
                        pascals(interval.least), pascals(interval.most))};
  }
  const double own = modulus.equilibrium();
  if (own >= interval.least && own <= interval.most) return {};
  return {fmt::format("the {} modulus of the material, {}, is not among {} to {}", name, pascals(own),
                      pascals(interval.least), pascals(interval.most))};
}

std::vector<Material> materials_of(const std::vector<Stage>& stages) {
  std::vector<Material> materials;
  for (const auto& stage : stages) std::ranges::copy(named_materials(stage), std::back_inserter(materials));
  return materials;
}

}  // namespace

int varied_moduli(const std::vector<VariedMaterial>& varied) {
  int count = 0;
  for (const auto& [name, shear, bulk, others] : varied) {
    count += (shear ? 1 : 0) + (bulk ? 1 : 0) + (others.empty() ? 0 : 1);
  }
  return count;
}

std::vector<std::string> mistakes_of_varied(const VariedMaterial& varied, const std::vector<Stage>& stages) {
  const auto materials = materials_of(stages);
  const auto found = std::ranges::find(materials, varied.name, &Material::name);
  if (found == materials.end()) {
    std::vector<std::string> names;
    names.reserve(materials.size());
    for (const auto& material : materials) names.push_back(material.name);
    return {fmt::format("no stage has a material \"{}\"{}", varied.name, suggestion(varied.name, names))};
  }
  if (is_void(*found)) return {"a void has no moduli that could vary"};
  if (!varied.others.empty()) return {};
  if (!found->bulk.is_elastic() || !found->shear.is_elastic()) {
    return {fmt::format("{} relaxes, so that its moduli vary without this; expected an elastic material", varied.name)};
  }
  if (!varied.shear && !varied.bulk) return {"expected shear or bulk, each two moduli"};
  std::vector<std::string> mistakes;
  if (varied.shear) mistakes = mistakes_of_interval(*varied.shear, found->shear, "shear");
  if (varied.bulk)
    std::ranges::copy(mistakes_of_interval(*varied.bulk, found->bulk, "bulk"), std::back_inserter(mistakes));
  return mistakes;
}

std::vector<std::vector<Material>> choices_of_varied(const std::vector<VariedMaterial>& varied,
                                                     const std::vector<Material>& materials) {
  std::vector<std::vector<Material>> choices = {{}};
  for (const auto& one : varied) {
    const auto material = std::ranges::find(materials, one.name, &Material::name);
    if (material == materials.end()) continue;
    std::vector<std::vector<Material>> longer;
    for (const auto& choice : choices) {
      for (auto& sample : samples_of(one, *material)) {
        longer.push_back(choice);
        longer.back().push_back(std::move(sample));
      }
    }
    choices = std::move(longer);
  }
  return choices;
}

Stage with_materials(Stage stage, const std::vector<Material>& replacements) {
  const auto replace = [&replacements](Material& material) {
    const auto found = std::ranges::find(replacements, material.name, &Material::name);
    if (found != replacements.end()) material = *found;
  };
  if (auto* matrix = std::get_if<Material>(&stage.matrix)) replace(*matrix);
  for (auto& filler : stage.fillers) {
    replace(filler.material);
    if (filler.coating) replace(filler.coating->material);
  }
  return stage;
}

}  // namespace breccia
