#include "homogenisation/narrow_gaps.hpp"

#include "breccia/homogenisation/stage_discretisation.hpp"

#include "discretisation/contrast.hpp"
#include "homogenisation/run/test_requests.hpp"

namespace breccia {

bool has_narrow_films(const Stage& stage, const Grains<2>& grains) {
  constexpr double widest = 1.4;
  return grains.statistics.film < widest * stage.cell_size();
}

Mixing mixing_of(const Study& study, const Stage& stage, const StageMicrostructure& packed) {
  if (study.tests.mixing != Mixing::flow) return study.tests.mixing;
  const auto* grains = packed.content<Grains<2>>();
  const bool serves = grains == nullptr || has_narrow_films(stage, *grains);
  const bool are_stiffer = are_stiffer_than_matrix(materials_of(stage, expected_matrix(study, stage)));
  return serves && are_stiffer ? Mixing::flow : Mixing::series;
}

}  // namespace breccia
