#include "operator/cell_kinds.hpp"

#include <algorithm>
#include <map>

#include "breccia/error.hpp"

namespace breccia::quasistatic {

template <int dim>
CellKinds<dim>::CellKinds(const Discretisation<dim>& discretisation, Volumetric volumetric,
                          const IndexRange<dim>& own_cells)
    : volumetric_(volumetric), own_cells_(own_cells) {
  std::map<CellPhases<dim>, std::uint32_t> known;
  PetscInt strains = 0;  // of the cells before
  discretisation.grid().for_each_cell([&](const Index<dim>& cell) {
    const auto& phases = discretisation.cell(cell);
    if (std::find(phases.begin(), phases.end(), no_phase) != phases.end()) {
      throw InputError("quasi-static solver: a point has no material; empty cells are for the dynamic method");
    }
    const auto* mixture = discretisation.mixture(phases.front());
    if (own_cells.contains(cell)) {
      if (cell.front() == own_cells.begin.front()) strains_before_rows_.push_back(strains);
      const auto [kind, is_new] = known.emplace(phases, static_cast<std::uint32_t>(known.size()));
      if (is_new) {
        phases_.push_back(phases);
        mixed_.push_back(mixture != nullptr ? std::optional<MixedCell<dim>>(*mixture) : std::nullopt);
      }
      of_cells_.push_back(kind->second);
    }
    if (mixture != nullptr) strains += static_cast<PetscInt>(MixedCell<dim>::unknowns_of(*mixture));
  });
  if (volumetric == Volumetric::standard && !discretisation.mixtures().empty()) {
    throw InputError("quasi-static solver: expected averaged volumetric strains, which mixed cells have");
  }
}

template <int dim>
typename CellShape<dim>::Stiffness CellKinds<dim>::stiffness(std::size_t kind, std::span<const Moduli> moduli) const {
  typename Shape::PointModuli of_points{};
  if (mixed_[kind]) {
    of_points.fill(series_moduli<dim>(mixed_[kind]->mixture(), moduli));
  } else {
    for (std::size_t p = 0; p < of_points.size(); ++p) of_points[p] = moduli[phases_[kind][p]];
  }
  return Shape::stiffness(of_points, volumetric_);
}

template <int dim>
std::vector<typename CellShape<dim>::Stiffness> CellKinds<dim>::stiffnesses(std::span<const Moduli> moduli) const {
  std::vector<Stiffness> by_kind;
  by_kind.reserve(count());
  for (std::size_t kind = 0; kind < count(); ++kind) by_kind.push_back(stiffness(kind, moduli));
  return by_kind;
}

template <int dim>
std::optional<Moduli> CellKinds<dim>::uniform_moduli(std::size_t kind, std::span<const Moduli> moduli) const {
  if (mixed_[kind]) return series_moduli<dim>(mixed_[kind]->mixture(), moduli);
  const auto& phases = phases_[kind];
  const bool is_uniform = std::ranges::count(phases, phases.front()) == Shape::points;
  if (!is_uniform || volumetric_ == Volumetric::standard) return std::nullopt;
  return moduli[phases.front()];
}

template class CellKinds<2>;
template class CellKinds<3>;

}  // namespace breccia::quasistatic
