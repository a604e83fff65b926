#include "homogenisation/narrow_gaps.hpp"

#include <algorithm>

#include "breccia/homogenisation/stage_discretisation.hpp"

#include "discretisation/contrast.hpp"
#include "homogenisation/run/test_requests.hpp"
#include "study/test_rules.hpp"

namespace breccia {

namespace {

// Spheres almost touch where the gap between them is less than a cell and a tenth of their mean diameter.
constexpr double cells_between_spheres = 1.0, narrow_share_of_diameter = 0.1;

}  // namespace

bool has_narrow_gaps(const Stage& stage, const StageMicrostructure& packed) {
  constexpr double rounding = 1e-9, widest = cells_in_narrow_gaps * (1.0 - rounding), widest_film = 1.4;
  const double cells = std::min(packed.gap, packed.wall_gap) / stage.cell_size();
  return cells < (packed.grains() != nullptr ? widest_film : widest);
}

bool has_spheres_that_almost_touch(const Stage& stage, const StageMicrostructure& packed) {
  return packed.content<Microstructure<3>>() != nullptr && packed.gap < cells_between_spheres * stage.cell_size() &&
         packed.gap < narrow_share_of_diameter * packed.mean_diameter();
}

double least_cells_across_spheres(const StageMicrostructure& packed) {
  const double diameter = packed.mean_diameter();
  return packed.gap < narrow_share_of_diameter * diameter ? cells_between_spheres * diameter / packed.gap : 0.0;
}

double narrowest_tested_gap(int dimensions) {
  return dimensions == 2 ? 0.002 : 0.003;
}

bool has_particles_that_touch(const Stage& stage, const StageMicrostructure& packed) {
  constexpr double rounding = 1e-6;
  return packed.gap < narrowest_tested_gap(stage.dimensions()) * packed.mean_diameter() * (1.0 - rounding);
}

bool has_soft_fillers(const Study& study, const Stage& stage) {
  return !stage.fillers.empty() && are_softer_than_matrix(materials_of(stage, expected_matrix(study, stage)));
}

Mixing mixing_of(const Study& study, const Stage& stage, const StageMicrostructure& packed) {
  if (study.tests.mixing != Mixing::flow) return study.tests.mixing;
  if (model_of(study.tests, stage) == Model::films) return Mixing::series;
  const bool are_stiffer = are_stiffer_than_matrix(materials_of(stage, expected_matrix(study, stage)));
  return has_narrow_gaps(stage, packed) && are_stiffer ? Mixing::flow : Mixing::series;
}

}  // namespace breccia
