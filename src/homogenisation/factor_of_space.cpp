#include "homogenisation/factor_of_space.hpp"

#include <algorithm>
#include <cmath>

#include "discretisation/contrast.hpp"
#include "homogenisation/run/test_requests.hpp"
#include "homogenisation/stage_materials.hpp"
#include "study/chain.hpp"

namespace breccia {

std::optional<FactorOfSpace> factor_of_space(const Study& study, const Stage& stage, const StageFindings& result) {
  constexpr double largest_exponent = 0.25;
  const auto is_disc = [](const Filler& filler) { return !filler.shape && !filler.coating; };
  const bool has_random_discs = stage.dimensions() == 2 && stage.has_seed() && !stage.has_grains() &&
                                !stage.has_crystals() && std::ranges::all_of(stage.fillers, is_disc);
  if (!has_random_discs || !are_stiffer_than_matrix(materials_of(stage, expected_matrix(study, stage)))) return {};
  const auto shear = main_shear(study.tests.loads);
  const auto* const test = shear ? find_preferred_test(result.tests, *shear, Boundary::periodic) : nullptr;
  if (test == nullptr) return {};
  const auto& binder = binder_of(study, stage).shear;
  constexpr double flowed_away = 1e-6;
  std::optional<FactorOfSpace> largest;
  for (const auto& [time, modulus] : test->modulus) {
    if (!(binder.at(time) > flowed_away * binder.unrelaxed())) break;
    const double ratio = std::pow(modulus / binder.at(time), largest_exponent);
    if (std::isfinite(ratio) && (!largest || ratio > largest->ratio)) largest = FactorOfSpace{time, ratio};
  }
  return largest;
}

}  // namespace breccia
