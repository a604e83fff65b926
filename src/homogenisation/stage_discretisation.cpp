#include "breccia/homogenisation/stage_discretisation.hpp"

#include <map>
#include <string>
#include <utility>

#include "breccia/discretisation/mixed_cells.hpp"

namespace breccia {

Phases phases_of(const Stage& stage) {
  std::vector<std::string> names = {std::string(name_of_matrix_phase)};
  if (stage.filler) names.emplace_back(name_of_filler_phase);
  return Phases(std::move(names));
}

std::vector<Material> materials_of(const Stage& stage, const Material& matrix) {
  std::map<std::string, Material> by_phase = {{std::string(name_of_matrix_phase), matrix}};
  if (stage.filler) by_phase.emplace(name_of_filler_phase, stage.filler->material);
  return phases_of(stage).materials(by_phase);
}

Discretisation<2> discretise(const Stage& stage, const Microstructure<2>& microstructure, int cells, Mixing mixing) {
  const auto phases = phases_of(stage);
  std::vector<PhaseIndex> of_particles;
  if (!microstructure.particles.empty()) {
    of_particles.assign(microstructure.particles.size(), phases.index_of(name_of_filler_phase));
  }
  const auto matrix = phases.index_of(name_of_matrix_phase);
  return mixing == Mixing::points ? discretise(microstructure, cells, matrix, of_particles)
                                  : discretise_mixed(microstructure, cells, matrix, of_particles, phases.size());
}

std::size_t point_count(int cells) {
  return Grid<2>{.cells = {cells, cells}}.cell_count() * Discretisation<2>::points_per_cell;
}

}  // namespace breccia
