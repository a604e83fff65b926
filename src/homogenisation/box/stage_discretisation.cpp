#include "breccia/homogenisation/stage_discretisation.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
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
#include "homogenisation/narrow_gaps.hpp"
#include "microstructure/vector_algebra.hpp"
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

namespace {

/// The phases of the particles of a box. Throws InputError when a particle belongs to no filler of the stage.
template <class Box>
std::vector<ParticlePhases> phases_of_particles(const Stage& stage, const Box& box) {
  const auto of_fillers = phases_of_fillers(stage);
  std::vector<ParticlePhases> of_particles;
  for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
    const auto filler = box.filler_of(particle);
    if (filler >= of_fillers.size()) {
      throw InputError(fmt::format("stage {}: a particle is of filler {}, counted from 0, but there are only {}",
                                   stage.name, filler, of_fillers.size()));
    }
    of_particles.push_back(of_fillers[filler]);
  }
  return of_particles;
}

/// The corners of a cell, counter-clockwise, without those that are nearer to the one before than `least` [m].
std::vector<Vector<2>> corners_of(const ConvexCell<2>& cell, double least) {
  std::vector<Vector<2>> corners;
  std::size_t corner = 0;
  do {
    const auto& position = cell.corners()[corner].position;
    if (corners.empty() || norm(position - corners.back()) > least) corners.push_back(position);
    corner = cell.corner_across(corner, 0);
  } while (corner != 0);
  if (norm(corners.front() - corners.back()) <= least) corners.pop_back();
  return corners;
}

/// The grains without the films between them, as polygons.
ParticleBox as_particles(const Grains<2>& grains) {
  const Tessellation<2> tessellation(grains.sites);
  ParticleBox box = {.side = tessellation.side(), .walls = tessellation.walls()};
  for (std::size_t site = 0; site < tessellation.size(); ++site) {
    const auto grain = tessellation.grain(site, grains.statistics.film);
    if (grain.is_empty()) continue;
    constexpr double least = 1e-9;  // of the side of the box
    const auto corners = corners_of(grain, least * box.side);
    if (corners.size() < 3) continue;
    auto middle = tessellation.sites().sites[site].position + centroid(corners);
    for (double& x : middle) x -= box.walls == Walls::periodic ? box.side * std::floor(x / box.side) : 0.0;
    box.particles.push_back({ConvexPolygon(corners), Pose(middle, 0.0)});
  }
  return box;
}

/// The particles of a stage, for cells with flow through the gaps between them.
template <int dim>
std::shared_ptr<const ParticlesInBox<dim>> particles_with_gaps(const Stage& stage,
                                                               decltype(ParticlesInBox<dim>::box) box) {
  auto phases = phases_of_particles(stage, box);
  const auto matrix = phases_of(stage).index_of(name_of_matrix_phase);
  return std::make_shared<const ParticlesInBox<dim>>(ParticlesInBox<dim>{std::move(box), matrix, std::move(phases)});
}

/// Discs and spheres in the form in which ParticlesInBox has them.
ParticleBox in_box(const Microstructure<2>& discs) {
  return as_particles(discs);
}
const Microstructure<3>& in_box(const Microstructure<3>& spheres) {
  return spheres;
}

}  // namespace

template <int dim>
Discretisation<dim> discretise(const Stage& stage, const Microstructure<dim>& microstructure, int cells, Mixing mixing,
                               const CellLayers& layers) {
  const auto phases = phases_of(stage);
  const auto matrix = phases.index_of(name_of_matrix_phase);
  const auto of_particles = phases_of_particles(stage, microstructure);
  const std::span<const ParticlePhases> particles(of_particles);
  if (mixing == Mixing::points) return discretise(microstructure, cells, matrix, particles, layers);
  auto discretisation = discretise_mixed(microstructure, cells, matrix, particles, phases.size(), layers);
  if (mixing == Mixing::flow && !microstructure.particles.empty()) {
    discretisation.set_particles_with_gaps(particles_with_gaps<dim>(stage, in_box(microstructure)));
  }
  return discretisation;
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
  Discretisation<2> operator()(const ParticleBox& particles) const {
    auto discretisation = on<2>(labelling_of(stage, particles));
    if (mixing == Mixing::flow) discretisation.set_particles_with_gaps(particles_with_gaps<2>(stage, particles));
    return discretisation;
  }
  Discretisation<3> operator()(const EllipsoidBox& ellipsoids) const { return on<3>(labelling_of(stage, ellipsoids)); }
  Discretisation<2> operator()(const Grains<2>& grains) const {
    auto discretisation = on<2>(labelling_of(stage, grains));
    if (mixing == Mixing::flow) {
      discretisation.set_particles_with_gaps(particles_with_gaps<2>(stage, as_particles(grains)));
    }
    return discretisation;
  }
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
  const auto of_gaps = mixing == Mixing::flow && !has_narrow_gaps(stage, packed) ? Mixing::series : mixing;
  return std::visit(
      [&](const auto& box) -> StageDiscretisation { return discretise(stage, box, cells, of_gaps, layers); },
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
