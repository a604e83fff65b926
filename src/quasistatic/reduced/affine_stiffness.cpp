#include "reduced/affine_stiffness.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::quasistatic {

std::vector<Moduli> AffineStiffness::moduli_at(std::span<const double> parameters) const {
  auto moduli = constant;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t m = 0; m < moduli.size(); ++m) {
      moduli[m].bulk += parameters[i] * parts[i].unit[m].bulk;
      moduli[m].shear += parameters[i] * parts[i].unit[m].shear;
    }
  }
  return moduli;
}

AffineStiffness affine_stiffness(const std::vector<Material>& materials, PhaseIndex matrix) {
  const auto count = materials.size();
  AffineStiffness stiffness = {std::vector<Moduli>(count, {0.0, 0.0}), {}};
  for (std::size_t m = 0; m < count; ++m) {
    const auto& [name, density, bulk, shear] = materials[m];
    if (m == matrix) continue;
    if (!bulk.is_elastic() || !shear.is_elastic()) {
      throw InputError(
          fmt::format("reduced basis: {} relaxes; with a filler that relaxes, take solver = \"stepping\"", name));
    }
    stiffness.constant[m] = {bulk.equilibrium(), shear.equilibrium()};
  }
  const auto add_part = [&](ElasticModulus modulus, const Moduli& one) {
    std::vector<Moduli> unit(count, {0.0, 0.0});
    unit.at(matrix) = one;
    stiffness.parts.push_back({{std::string(name_of_matrix_phase), modulus}, std::move(unit)});
  };
  add_part(ElasticModulus::shear, {.bulk = 0.0, .shear = 1.0});
  add_part(ElasticModulus::bulk, {.bulk = 1.0, .shear = 0.0});
  return stiffness;
}

}  // namespace breccia::quasistatic
