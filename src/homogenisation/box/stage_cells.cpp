#include "homogenisation/box/stage_cells.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/point_labels.hpp"

#include "homogenisation/box/crystal_orientations.hpp"
#include "homogenisation/box/fillers_of_particles.hpp"
#include "homogenisation/box/stage_labelling.hpp"

namespace breccia {
namespace {

/// The phases of the particles of a box: that of the filler, and the particle's own where it is a crystal.
struct PhasesOfParticles {
  std::vector<PhaseIndex> of_filler, own;
};

/// A discretisation in which points have the phase of their particle in place of that of its filler. `particles` has
/// the particle at each point, `added` is the number of the new phases.
template <int dim>
Discretisation<dim> with_own_phases(const Discretisation<dim>& discretisation, const PhasesOfParticles& phases,
                                    const std::vector<std::int32_t>& particles, std::size_t added) {
  const auto& grid = discretisation.grid();
  const auto& mixtures = discretisation.mixtures();
  const auto moved = [added](PhaseIndex number) { return static_cast<PhaseIndex>(number + added); };
  auto cells = std::make_shared<CellArray<dim>>(grid.cell_count());
  grid.for_each_cell([&](const Index<dim>& cell) {
    auto& of_cell = cells.get()[grid.cell_index(cell)] = discretisation.cell(cell);
    if (discretisation.mixture(of_cell.front()) != nullptr) {
      of_cell.fill(moved(of_cell.front()));
      return;
    }
    for (int p = 0; p < Discretisation<dim>::points_per_cell; ++p) {
      auto& phase = of_cell[static_cast<std::size_t>(p)];
      const auto particle = static_cast<std::size_t>(particles[grid.point_index(cell, p)]);
      if (particle < phases.own.size() && phase == phases.of_filler[particle]) phase = phases.own[particle];
    }
  });
  Discretisation<dim> changed(grid, std::move(cells), mixtures,
                              mixtures.empty() ? no_phase : moved(discretisation.first_mixture()));
  changed.set_particles_with_gaps(discretisation.particles_with_gaps());
  return changed;
}

}  // namespace

StageCells cells_of(const Stage& stage, const StageMicrostructure& packed, StageDiscretisation discretisation) {
  if (!stage.has_crystals()) return {std::move(discretisation)};
  const auto fillers = fillers_of_particles(packed);
  const auto orientations = orientations_of_particles(stage, fillers);
  const auto phases_of_filler = phases_of_fillers(stage);
  const auto other_phases = phases_of(stage).size();
  Crystals crystals;
  PhasesOfParticles phases;
  for (std::size_t particle = 0; particle < fillers.size(); ++particle) {
    const auto of_filler = phases_of_filler[fillers[particle]].phase;
    phases.of_filler.push_back(of_filler);
    phases.own.push_back(of_filler);
    if (!orientations[particle]) continue;
    const auto number = other_phases + crystals.size();
    if (number >= no_phase) {
      throw InputError(fmt::format("stage {}: expected at most {} crystals, got more", stage.name, crystals.size()));
    }
    phases.own.back() = static_cast<PhaseIndex>(number);
    const auto& crystal = *stage.fillers[fillers[particle]].crystal;
    crystals.emplace(phases.own.back(), CrystalPhase{crystal_stiffness(crystal, *orientations[particle]), of_filler});
  }
  const auto particles = point_labels(stage, packed, cells_along(discretisation)).particles;
  const auto put_in = [&](const auto& points) -> StageDiscretisation {
    if (other_phases + crystals.size() + points.mixtures().size() > no_phase) {
      throw InputError(
          fmt::format("stage {}: {} crystals and {} mixtures in cells are more than can be numbered; "
                      "expected fewer particles or cells",
                      stage.name, crystals.size(), points.mixtures().size()));
    }
    return with_own_phases(points, phases, particles, crystals.size());
  };
  auto with_crystals = std::visit(put_in, discretisation);
  return {std::move(with_crystals), std::move(crystals)};
}

}  // namespace breccia
