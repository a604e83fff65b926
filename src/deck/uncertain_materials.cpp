#include "deck/uncertain_materials.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "breccia/error.hpp"

#include "deck/materials.hpp"
#include "deck/tests.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

std::vector<UncertainInput> inputs_of(const std::string& material, const std::vector<UncertainInput>& inputs) {
  std::vector<UncertainInput> own;
  std::ranges::copy_if(inputs, std::back_inserter(own),
                       [&](const UncertainInput& input) { return material_of(input) == material; });
  return own;
}

/// The extreme coordinates of an input, and all of its choices.
std::vector<double> extremes_of(const UncertainInput& input) {
  const auto choices = choices_of(input);
  if (choices == 0) return {-most_score, most_score};
  std::vector<double> all;
  for (std::size_t i = 0; i < choices; ++i) all.push_back(static_cast<double>(i));
  return all;
}

/// All combinations of the extremes of inputs; empty where there are too many of them.
std::vector<std::vector<double>> extreme_combinations(const std::vector<UncertainInput>& inputs) {
  constexpr std::size_t most = 64;
  std::vector<std::vector<double>> combinations = {{}};
  for (const auto& input : inputs) {
    std::vector<std::vector<double>> longer;
    for (const auto& combination : combinations) {
      for (const double extreme : extremes_of(input)) {
        longer.push_back(combination);
        longer.back().push_back(extreme);
      }
    }
    combinations = std::move(longer);
    if (combinations.size() > most) return {};
  }
  return combinations;
}

/// The material at coordinates of its inputs, with the scores of distributions multiplied by a factor.
Material material_at(const Deck& document, const std::string& material, const std::vector<UncertainInput>& inputs,
                     const std::vector<double>& coordinates, double factor) {
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double coordinate = choices_of(inputs[i]) > 0 ? coordinates[i] : factor * coordinates[i];
    settings.push_back({inputs[i].name, {}, {value_at(inputs[i], coordinate), {}}});
  }
  return material_with(document, material, settings).material;
}

/// The material with all combinations of the extremes of its inputs; where no solid has a combination, the one nearest
/// to it that a solid has.
std::vector<Material> extreme_materials(const Deck& document, const std::string& material,
                                        const std::vector<UncertainInput>& inputs) {
  constexpr std::array factors = {1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1};
  std::vector<Material> materials;
  for (const auto& coordinates : extreme_combinations(inputs)) {
    for (const double factor : factors) {
      try {
        materials.push_back(material_at(document, material, inputs, coordinates, factor));
        break;
      } catch (const InputError&) {
        continue;
      }
    }
  }
  return materials;
}

/// The interval of a modulus of elastic materials; nothing where all have the same.
std::optional<ModulusInterval> interval_of(const std::vector<Material>& materials, PronySeries Material::*modulus) {
  constexpr double rounding = 1e-9;
  const auto value = [modulus](const Material& material) { return (material.*modulus).equilibrium(); };
  const auto [least, most] = std::ranges::minmax_element(materials, {}, value);
  if (value(*most) <= (1.0 + rounding) * value(*least)) return std::nullopt;
  return ModulusInterval{value(*least), value(*most)};
}

VariedMaterial varied_over(const Material& material, std::vector<Material> extremes) {
  if (!material.bulk.is_elastic() || !material.shear.is_elastic()) {
    return {.name = material.name, .others = std::move(extremes)};
  }
  extremes.push_back(material);
  return {.name = material.name,
          .shear = interval_of(extremes, &Material::shear),
          .bulk = interval_of(extremes, &Material::bulk)};
}

bool is_varied(const Study& study, const std::string& material) {
  return std::ranges::find(study.tests.varied, material, &VariedMaterial::name) != study.tests.varied.end();
}

/// Whether the deck gives the tolerance of the reduced basis.
bool gives_tolerance(const Deck& document) {
  const auto tests = document.root().optional_section("tests");
  const auto quasistatic = tests ? tests->optional_section("quasistatic") : std::nullopt;
  return quasistatic && quasistatic->has("tolerance");
}

}  // namespace

std::optional<std::string> material_of(const UncertainInput& input) {
  const auto steps = split_path(input.name);
  if (!steps || steps->size() < 3 || steps->front() != "materials" || steps->back() == "density") return std::nullopt;
  return (*steps)[1];
}

ShiftedMaterial material_with(const Deck& document, const std::string& material, const std::vector<Setting>& settings) {
  auto changed = document.unread_copy();
  for (const auto& setting : settings) changed.set(setting);
  // The keys of the rest of the deck are no matter here.
  changed.root().accept_all_keys();
  const auto materials = changed.root().section("materials");
  materials.accept_all_keys();
  auto read = read_shifted_material(materials.section(material), material);
  refuse_mistakes(document.path(), changed.mistakes());
  return read;
}

void vary_uncertain_materials(const Deck& document, Study& study) {
  for (const auto& [material, shift, constants, expansion] : study.materials) {
    const auto inputs = inputs_of(material.name, study.uncertain);
    if (inputs.empty() || constants || is_varied(study, material.name)) continue;
    const auto extremes = extreme_materials(document, material.name, inputs);
    if (extremes.empty()) continue;
    auto candidate = study;
    const auto& varied = candidate.tests.varied.emplace_back(varied_over(material, extremes));
    if (!mistakes_of_varied(varied, study.stages).empty() || !contradictions(candidate).empty()) continue;
    if (!gives_tolerance(document)) candidate.tests.quasistatic.sampling.tolerance = coarse_tolerance;
    study.tests = std::move(candidate.tests);
  }
}

bool is_answered_by_responses(const UncertainInput& input, const Study& study) {
  const auto material = material_of(input);
  return material && is_varied(study, *material);
}

}  // namespace breccia
