#include "breccia/homogenisation/stage_discretisation.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/grain_cells.hpp"
#include "discretisation/image_cells.hpp"
#include "discretisation/joined_discretisation.hpp"
#include "discretisation/labels.hpp"
#include "discretisation/mixed_cells.hpp"
#include "homogenisation/box/stage_labelling.hpp"
#include "parallel/common_failure.hpp"
#include "parallel/machine.hpp"

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

/// Discretises a box: a visitor of its content.
struct Discretise {
  const Stage& stage;
  int cells;
  Mixing mixing;
  const CellLayers& layers;

  template <int dim>
  Discretisation<dim> operator()(const Microstructure<dim>& balls) const {
    return discretise(stage, balls, cells, mixing, layers);
  }
  Discretisation<2> operator()(const ParticleBox& particles) const { return on<2>(labelling_of(stage, particles)); }
  Discretisation<3> operator()(const EllipsoidBox& ellipsoids) const { return on<3>(labelling_of(stage, ellipsoids)); }
  Discretisation<2> operator()(const Grains<2>& grains) const { return on<2>(labelling_of(stage, grains)); }
  Discretisation<3> operator()(const Grains<3>& grains) const {
    return mixing == Mixing::points ? on<3>(labelling_of(stage, grains)) : exactly(grains);
  }
  template <int dim>
  Discretisation<dim> operator()(const SharedImage<dim>& image) const {
    const auto grid = grid_of_stage<dim>(stage, cells);
    const auto of_labels = phases_of_labels(stage);
    return mixing == Mixing::points ? discretise<dim>(grid, *image, of_labels, layers)
                                    : discretise_mixed<dim>(grid, *image, of_labels, phases_of(stage).size(), layers);
  }

 private:
  template <int dim>
  [[nodiscard]] Discretisation<dim> on(const Labelling<dim>& labelling) const {
    const auto grid = grid_of_stage<dim>(stage, cells);
    return mixing == Mixing::points ? discretise<dim>(grid, labelling, layers)
                                    : discretise_mixed(grid, labelling, phases_of(stage).size(), layers);
  }

  /// Discretises grains in three dimensions with exact fractions of the mixed cells; a division of the cells into parts
  /// would need very many of them.
  [[nodiscard]] Discretisation<3> exactly(const Grains<3>& grains) const {
    const auto phases = phases_of(stage);
    return discretise_mixed(Tessellation<3>(grains.sites), grains.statistics.film, cells,
                            phases.index_of(name_of_matrix_phase),
                            phases.index_of(phase_of(stage, stage.fillers.front().material)), phases.size(), layers);
  }
};

}  // namespace

template <int dim>
Discretisation<dim> discretise(const Stage& stage, const Box<dim>& box, int cells, Mixing mixing,
                               const CellLayers& layers) {
  return std::visit(Discretise{stage, cells, mixing, layers}, box);
}

template Discretisation<2> discretise(const Stage&, const Box<2>&, int, Mixing, const CellLayers&);
template Discretisation<3> discretise(const Stage&, const Box<3>&, int, Mixing, const CellLayers&);

StageDiscretisation discretise(const Stage& stage, const StageMicrostructure& packed, int cells, Mixing mixing,
                               const CellLayers& layers) {
  return std::visit(
      [&](const auto& box) -> StageDiscretisation { return discretise(stage, box, cells, mixing, layers); },
      packed.box);
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
  if (stage.dimensions() == 3) {
    return Grid<3>{.cells = {cells, cells, cells}}.cell_count() * Discretisation<3>::points_per_cell;
  }
  return Grid<2>{.cells = {cells, cells}}.cell_count() * Discretisation<2>::points_per_cell;
}

}  // namespace breccia
