#include "homogenisation/respond/elastic_chain.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "quasistatic/reduced/response_gradient.hpp"
#include "virtual_test/bulk_test.hpp"

namespace breccia {
namespace {

/// The response on the finest grid. Throws InputError if there is none.
const ReducedResponse& finest_response(const StageResponses& stage, Load load, Boundary boundary) {
  const StageResponses::Entry* finest = nullptr;
  for (const auto& entry : stage.entries) {
    if (entry.response.load != load || entry.response.boundary != boundary) continue;
    if (finest == nullptr || finest->grid < entry.grid) finest = &entry;
  }
  if (finest != nullptr) return finest->response;
  throw InputError(fmt::format("stage {} has no reduced response under {} with the {} boundary", stage.stage,
                               name_of(load), name_of(boundary)));
}

/// Adds the derivatives of one modulus, times a factor, to those of another (the chain rule).
void add(std::map<std::string, ComplexModuli>& sum, std::complex<double> factor,
         const std::map<std::string, ComplexModuli>& gradient) {
  for (const auto& [material, by] : gradient) {
    auto& to = sum[material];
    to.bulk += factor * by.bulk;
    to.shear += factor * by.shear;
  }
}

/// The shear and the bulk modulus of a phase, with their derivatives.
struct GradedModuli {
  ModulusAndGradient shear, bulk;

  [[nodiscard]] ComplexModuli moduli() const { return {.bulk = bulk.modulus, .shear = shear.modulus}; }
};

GradedModuli moduli_of_material(const std::string& name, const ComplexModuli& moduli) {
  return {{moduli.shear, {{name, {.bulk = 0.0, .shear = 1.0}}}}, {moduli.bulk, {{name, {.bulk = 1.0, .shear = 0.0}}}}};
}

/// The moduli of a stage from its tests under shear and bulk.
GradedModuli moduli_of_stage(ModulusAndGradient shear, ModulusAndGradient bulk, int dimensions) {
  const double share = shear_in_bulk_test(dimensions);
  bulk.modulus -= share * shear.modulus;
  add(bulk.gradient, -share, shear.gradient);
  return {std::move(shear), std::move(bulk)};
}

}  // namespace

ModulusAndGradient ElasticChain::modulus(const std::string& name, TestLoad load) const {
  const auto& stage = stage_named(name);
  if (!load.is_isotropic()) return modulus_under(stage, *load.of_test());
  const auto shears = isotropic_shears(stage.dimensions);
  const double share = 1.0 / static_cast<double>(shears.size());
  ModulusAndGradient mean;
  if (boundary_ != Boundary::traction) {
    for (const auto shear : shears) {
      const auto of_shear = modulus_under(stage, shear);
      mean.modulus += share * of_shear.modulus;
      add(mean.gradient, share, of_shear.gradient);
    }
    return mean;
  }
  // The mean of the compliances 1/m is 1/M, so that dM = M^2 mean(dm / m^2) (theory, Eq. 13b).
  std::complex<double> compliance = 0.0;
  std::map<std::string, ComplexModuli> gradient;
  for (const auto shear : shears) {
    const auto [modulus, of_shear] = modulus_under(stage, shear);
    compliance += share / modulus;
    add(gradient, share / (modulus * modulus), of_shear);
  }
  mean.modulus = 1.0 / compliance;
  add(mean.gradient, mean.modulus * mean.modulus, gradient);
  return mean;
}

ModulusAndGradient ElasticChain::modulus_under(const StageResponses& stage, Load load) const {
  const auto& response = finest_response(stage, load, boundary_);
  std::vector<GradedModuli> phases;
  std::vector<ComplexModuli> moduli;
  for (const auto& phase : response.phases()) {
    if (phase != name_of_matrix_phase) {
      const auto& material = stage.other_phases.at(phase).name;
      phases.push_back(moduli_of_material(material, moduli_of(material)));
    } else if (const auto* const earlier = std::get_if<EarlierStage>(&stage.matrix)) {
      const auto& below = stage_named(earlier->name);
      phases.push_back(
          moduli_of_stage(modulus(earlier->name, below.shear), modulus(earlier->name, Load::bulk), below.dimensions));
    } else {
      phases.push_back(moduli_of_material(name_of(stage.matrix), moduli_of(name_of(stage.matrix))));
    }
    moduli.push_back(phases.back().moduli());
  }
  const auto [value, gradient] = breccia::modulus_and_gradient(response, moduli);
  ModulusAndGradient found{value};
  for (std::size_t i = 0; i < phases.size(); ++i) {
    add(found.gradient, gradient[i].shear, phases[i].shear.gradient);
    add(found.gradient, gradient[i].bulk, phases[i].bulk.gradient);
  }
  return found;
}

const StageResponses& ElasticChain::stage_named(const std::string& stage) const {
  const auto found = std::ranges::find(stages_, stage, &StageResponses::stage);
  if (found != stages_.end()) return *found;
  throw InputError(fmt::format("there is no reduced response of a stage {}", stage));
}

const ComplexModuli& ElasticChain::moduli_of(const std::string& material) const {
  const auto found = moduli_.find(material);
  if (found != moduli_.end()) return found->second;
  throw InputError(fmt::format("no moduli of {}, which varies", material));
}

}  // namespace breccia
