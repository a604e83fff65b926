#include "quasistatic/reduced/affine_stiffness.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

namespace breccia::quasistatic {

namespace {

/// Adds the moduli of the parts that vary to moduli by material.
void add_varying(std::vector<Moduli>& moduli, const std::vector<AffineStiffness::Part>& parts,
                 std::span<const double> parameters) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t m = 0; m < moduli.size(); ++m) {
      moduli[m].bulk += parameters[i] * parts[i].unit[m].bulk;
      moduli[m].shear += parameters[i] * parts[i].unit[m].shear;
    }
  }
}

/// Throws InputError, with every mistake, where these phases cannot vary among these materials.
void require_phases_that_can_vary(const std::vector<Material>& materials, std::span<const VaryingPhase> varying) {
  std::vector<std::string> mistakes;
  if (varying.empty()) mistakes.emplace_back("expected at least one phase whose moduli vary");
  for (auto one = varying.begin(); one != varying.end(); ++one) {
    const auto index = one->index;
    const auto& name = one->name;
    if (index >= materials.size()) {
      mistakes.push_back(fmt::format("the phase {} has number {}, but there are materials for {} phases", name, index,
                                     materials.size()));
    }
    const bool is_twice = std::any_of(varying.begin(), one, [&](const VaryingPhase& earlier) {
      return earlier.index == index || earlier.name == name;
    });
    if (is_twice) mistakes.push_back(fmt::format("the phase {}, number {}, is given twice", name, index));
  }
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const auto& material = materials[m];
    const bool is_elastic = material.bulk.is_elastic() && material.shear.is_elastic();
    if (is_elastic || std::ranges::find(varying, m, &VaryingPhase::index) != varying.end()) continue;
    mistakes.push_back(fmt::format(
        "{} relaxes: expected its phase among those whose moduli vary, or stepping through time", material.name));
  }
  if (!mistakes.empty()) throw InputError(fmt::format("reduced basis: {}", fmt::join(mistakes, "; ")));
}

}  // namespace

std::vector<Moduli> AffineStiffness::moduli_at(std::span<const double> parameters) const {
  auto moduli = constant;
  add_varying(moduli, parts, parameters);
  return moduli;
}

std::vector<Moduli> AffineStiffness::varying_moduli_at(std::span<const double> parameters) const {
  std::vector<Moduli> moduli(constant.size(), {0.0, 0.0});
  add_varying(moduli, parts, parameters);
  return moduli;
}

AffineStiffness affine_stiffness(const std::vector<Material>& materials, std::span<const VaryingPhase> varying) {
  require_phases_that_can_vary(materials, varying);
  AffineStiffness stiffness;
  for (const auto& material : materials) {
    stiffness.constant.push_back({material.bulk.equilibrium(), material.shear.equilibrium()});
  }
  for (const auto& [index, name] : varying) {
    stiffness.constant[index] = {0.0, 0.0};
    const auto add_part = [&stiffness, count = materials.size(), phase = index, &phase_name = name](
                              ElasticModulus modulus, const Moduli& one) {
      std::vector<Moduli> unit(count, {0.0, 0.0});
      unit[phase] = one;
      stiffness.parts.push_back({{phase_name, modulus}, phase, std::move(unit)});
    };
    add_part(ElasticModulus::shear, {.bulk = 0.0, .shear = 1.0});
    add_part(ElasticModulus::bulk, {.bulk = 1.0, .shear = 0.0});
  }
  return stiffness;
}

}  // namespace breccia::quasistatic
