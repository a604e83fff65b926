#include "breccia/homogenisation/stage_discretisation.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "breccia/discretisation/grain_cells.hpp"
#include "breccia/discretisation/image_cells.hpp"
#include "breccia/discretisation/joined_discretisation.hpp"
#include "breccia/discretisation/labels.hpp"
#include "breccia/discretisation/mixed_cells.hpp"
#include "breccia/error.hpp"
#include "breccia/parallel/common_failure.hpp"
#include "breccia/parallel/machine.hpp"

#include "stage_labelling.hpp"

namespace breccia {

Phases phases_of(const Stage& stage) {
  return Phases(phase_names(stage));
}

std::vector<Material> materials_of(const Stage& stage, const Material& matrix) {
  std::map<std::string, Material> by_phase = {{std::string(name_of_matrix_phase), matrix}};
  for (const auto& filler : stage.fillers) {
    by_phase.emplace(phase_of(stage, filler.material), filler.material);
    if (filler.coating) by_phase.emplace(phase_of(stage, filler.coating->material), filler.coating->material);
  }
  return phases_of(stage).materials(by_phase);
}

template <int dim>
Discretisation<dim> discretise(const Stage& stage, const Microstructure<dim>& microstructure, int cells, Mixing mixing,
                               const CellLayers& layers) {
  const auto phases = phases_of(stage);
  const auto of_fillers = phases_of_fillers(stage);
  std::vector<ParticlePhases> of_particles;
  for (std::size_t particle = 0; particle < microstructure.particles.size(); ++particle) {
    const auto filler = microstructure.filler_of(particle);
    if (filler >= of_fillers.size()) {
      throw InputError(fmt::format("stage {}: a particle is of filler {}, counted from 0, but there are only {}",
                                   stage.name, filler, of_fillers.size()));
    }
    of_particles.push_back(of_fillers[filler]);
  }
  const auto matrix = phases.index_of(name_of_matrix_phase);
  const std::span<const ParticlePhases> particles(of_particles);
  return mixing == Mixing::points ? discretise(microstructure, cells, matrix, particles, layers)
                                  : discretise_mixed(microstructure, cells, matrix, particles, phases.size(), layers);
}

template Discretisation<2> discretise(const Stage&, const Microstructure<2>&, int, Mixing, const CellLayers&);
template Discretisation<3> discretise(const Stage&, const Microstructure<3>&, int, Mixing, const CellLayers&);

namespace {

template <int dim>
Grid<dim> grid_of_stage(const Stage& stage, int cells) {
  Grid<dim> grid = {.cells = {}, .cell_side = stage.side / cells};
  grid.cells.fill(cells);
  return grid;
}

template <int dim>
Discretisation<dim> discretise_image(const Stage& stage, const LabelImage<dim>& image, int cells, Mixing mixing,
                                     const CellLayers& layers) {
  const auto grid = grid_of_stage<dim>(stage, cells);
  const auto of_labels = phases_of_labels(stage);
  return mixing == Mixing::points ? discretise<dim>(grid, image, of_labels, layers)
                                  : discretise_mixed<dim>(grid, image, of_labels, phases_of(stage).size(), layers);
}

template <int dim>
Discretisation<dim> discretise_labelling(const Stage& stage, const Labelling<dim>& labelling, int cells, Mixing mixing,
                                         const CellLayers& layers) {
  const auto grid = grid_of_stage<dim>(stage, cells);
  return mixing == Mixing::points ? discretise<dim>(grid, labelling, layers)
                                  : discretise_mixed(grid, labelling, phases_of(stage).size(), layers);
}

/// Mixed cells of grains in three dimensions, which are exact: the parts of a cell would have to be many.
Discretisation<3> discretise_exactly(const Stage& stage, const StageGrains& grains, int cells,
                                     const CellLayers& layers) {
  const auto phases = phases_of(stage);
  return discretise_mixed(Tessellation<3>(*grains.sites_in_space), grains.film, cells,
                          phases.index_of(name_of_matrix_phase),
                          phases.index_of(phase_of(stage, stage.fillers.front().material)), phases.size(), layers);
}

}  // namespace

StageDiscretisation discretise(const Stage& stage, const StageMicrostructure& packed, int cells, Mixing mixing,
                               const CellLayers& layers) {
  if (const auto* image = stage.image()) return discretise_image(stage, *image, cells, mixing, layers);
  if (const auto* stack = stage.stack()) return discretise_image(stage, *stack, cells, mixing, layers);
  if (packed.spheres) return discretise(stage, *packed.spheres, cells, mixing, layers);
  if (stage.dimensions == 3) {
    const bool is_exact = packed.grains && mixing == Mixing::series;
    if (is_exact) return discretise_exactly(stage, *packed.grains, cells, layers);
    return discretise_labelling<3>(stage, labelling_in_space(stage, packed), cells, mixing, layers);
  }
  if (!packed.grains && !packed.shaped) return discretise(stage, packed.microstructure, cells, mixing, layers);
  return discretise_labelling<2>(stage, labelling_in_plane(stage, packed), cells, mixing, layers);
}

StageDiscretisation discretise_together(const Stage& stage, const StageMicrostructure& packed, int cells,
                                        Mixing mixing) {
  const auto layers = layers_of_part(cells, parallel::rank_on_machine(), parallel::ranks_on_machine());
  const auto phases = phases_of(stage).size();
  const auto made = parallel::made_by_all([&] { return discretise(stage, packed, cells, mixing, layers); });
  return std::visit([&](const auto& part) -> StageDiscretisation { return joined_on_machine(part, phases); }, made);
}

std::vector<double> fractions(const StageDiscretisation& discretisation, std::size_t phases) {
  return std::visit([phases](const auto& points) { return points.fractions(phases); }, discretisation);
}

int cells_along(const StageDiscretisation& discretisation) {
  return std::visit([](const auto& points) { return points.grid().cells[0]; }, discretisation);
}

std::size_t point_count(const Stage& stage, int cells) {
  if (stage.dimensions == 3) {
    return Grid<3>{.cells = {cells, cells, cells}}.cell_count() * Discretisation<3>::points_per_cell;
  }
  return Grid<2>{.cells = {cells, cells}}.cell_count() * Discretisation<2>::points_per_cell;
}

}  // namespace breccia
