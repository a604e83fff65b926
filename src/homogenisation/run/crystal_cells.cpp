#include "homogenisation/run/crystal_cells.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
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

/// Puts the phases of crystals into the cells of a test: a visitor of its composite.
struct PutIntoCells {
  const Stage& stage;
  const StageMicrostructure& packed;
  const std::vector<PhaseIndex>& of_particles;  ///< the phase of each particle; no_phase where it is isotropic
  const std::map<PhaseIndex, PhaseIndex>& fillers;

  template <int dim>
  void operator()(Discretisation<dim>& discretisation) const {
    const auto& grid = discretisation.grid();
    const auto labels = point_labels(stage, packed, grid.cells.front());
    const auto added = static_cast<PhaseIndex>(fillers.size());
    auto cells = std::make_shared<CellArray<dim>>(grid.cell_count());
    grid.for_each_cell([&](const Index<dim>& cell) {
      auto& phases = cells.get()[grid.cell_index(cell)] = discretisation.cell(cell);
      const bool is_mixed = discretisation.mixture(phases.front()) != nullptr;
      for (int p = 0; p < Discretisation<dim>::points_per_cell; ++p) {
        auto& phase = phases[static_cast<std::size_t>(p)];
        const auto particle = labels.particles[grid.point_index(cell, p)];
        if (is_mixed) {
          phase = static_cast<PhaseIndex>(phase + added);
        } else if (particle >= 0) {
          const auto crystal = fillers.find(of_particles[static_cast<std::size_t>(particle)]);
          if (crystal != fillers.end() && crystal->second == phase) phase = crystal->first;
        }
      }
    });
    const auto& mixtures = discretisation.mixtures();
    const auto first = mixtures.empty() ? no_phase : static_cast<PhaseIndex>(discretisation.first_mixture() + added);
    Discretisation<dim> with_crystals(grid, std::move(cells), mixtures, first);
    with_crystals.set_particles_with_gaps(discretisation.particles_with_gaps());
    discretisation = std::move(with_crystals);
  }
  template <int dim>
  void operator()(FilmProblem<dim>&) const {}
};

/// Number of the mixed cells' mixtures of a composite.
struct MixturesIn {
  template <int dim>
  std::size_t operator()(const Discretisation<dim>& discretisation) const {
    return discretisation.mixtures().size();
  }
  template <int dim>
  std::size_t operator()(const FilmProblem<dim>&) const {
    return 0;
  }
};

}  // namespace

void add_crystals(const Stage& stage, const StageMicrostructure& packed, QuasistaticTest& test) {
  if (std::ranges::none_of(stage.fillers, [](const Filler& filler) { return filler.crystal.has_value(); })) return;
  const auto fillers = fillers_of_particles(packed);
  const auto orientations = orientations_of_particles(stage, fillers);
  if (orientations.size() + test.materials.size() + std::visit(MixturesIn{}, test.composite) > no_phase) {
    throw InputError(fmt::format("stage {}: {} particles, which are crystals, are more than can be numbered",
                                 stage.name, orientations.size()));
  }
  const auto of_fillers = phases_of_fillers(stage);
  std::vector<PhaseIndex> of_particles(fillers.size(), no_phase);
  for (std::size_t particle = 0; particle < fillers.size(); ++particle) {
    if (!orientations[particle]) continue;
    const auto filler = fillers[particle];
    const auto phase = of_particles[particle] = static_cast<PhaseIndex>(test.materials.size());
    test.materials.push_back(test.materials[of_fillers[filler].phase]);
    test.crystals.emplace(phase, crystal_stiffness(*stage.fillers[filler].crystal, *orientations[particle]));
    test.fillers_of_crystals.emplace(phase, of_fillers[filler].phase);
  }
  std::visit(PutIntoCells{stage, packed, of_particles, test.fillers_of_crystals}, test.composite);
}

}  // namespace breccia
