#include "quasistatic/operator/cell_kinds.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "breccia/error.hpp"

namespace breccia::quasistatic {
namespace {

void require_no_crystals(const std::vector<Mixture>& mixtures, const Crystals& crystals) {
  const auto is_crystal = [&](const MixedPart& part) { return crystals.contains(part.phase); };
  const auto holds_crystal = [&](const Mixture& mixture) { return std::ranges::any_of(mixture, is_crystal); };
  if (std::ranges::none_of(mixtures, holds_crystal)) return;
  throw InputError("quasi-static solver: a mixed cell holds a crystal; expected isotropic phases, or cells of points");
}

}  // namespace

template <int dim>
CellKinds<dim>::CellKinds(const Discretisation<dim>& discretisation, Volumetric volumetric,
                          const IndexRange<dim>& own_cells, const Crystals& crystals,
                          std::span<const Material> materials, const gaps::GapCells<dim>* gaps)
    : volumetric_(volumetric), own_cells_(own_cells) {
  for (const auto& [phase, crystal] : crystals) {
    const auto stiffness = stiffness_in<dim>(crystal.stiffness);
    crystals_.emplace(phase, Crystal{stiffness, softer_moduli<dim>(stiffness).shear});
  }
  require_no_crystals(discretisation.mixtures(), crystals);
  const auto rule_of = [&](const Mixture& mixture) {
    return materials.empty() ? MixtureRule(mixture) : MixtureRule(mixture, materials);
  };
  std::map<CellPhases<dim>, std::uint32_t> known;
  PetscInt strains = 0;  // number of strains of the cells before
  discretisation.grid().for_each_cell([&](const Index<dim>& cell) {
    const auto& phases = discretisation.cell(cell);
    if (std::find(phases.begin(), phases.end(), no_phase) != phases.end()) {
      throw InputError("quasi-static solver: a point has no material; empty cells are for the dynamic method");
    }
    const auto* gap_cell = gaps != nullptr ? gaps->at(cell) : nullptr;
    const auto* mixture = gap_cell != nullptr ? &gap_cell->mixture : discretisation.mixture(phases.front());
    if (own_cells.contains(cell)) {
      if (cell.front() == own_cells.begin.front()) strains_before_rows_.push_back(strains);
      if (gap_cell != nullptr) {
        of_cells_.push_back(add_kind(phases, MixedCell<dim>(MixtureRule(gap_cell->mixture, gap_cell->shares))));
        has_gaps_.back() = true;
      } else if (const auto kind = known.find(phases); kind != known.end()) {
        of_cells_.push_back(kind->second);
      } else {
        of_cells_.push_back(
            add_kind(phases, mixture != nullptr ? std::optional<MixedCell<dim>>(rule_of(*mixture)) : std::nullopt));
        known.emplace(phases, of_cells_.back());
      }
    }
    if (mixture != nullptr) strains += static_cast<PetscInt>(MixedCell<dim>::unknowns_of(*mixture));
  });
  if (volumetric == Volumetric::standard && (!discretisation.mixtures().empty() || gaps != nullptr)) {
    throw InputError("quasi-static solver: expected averaged volumetric strains, which mixed cells have");
  }
}

template <int dim>
std::uint32_t CellKinds<dim>::add_kind(const CellPhases<dim>& phases, std::optional<MixedCell<dim>> mixed) {
  phases_.push_back(phases);
  mixed_.push_back(std::move(mixed));
  has_gaps_.push_back(false);
  return static_cast<std::uint32_t>(phases_.size() - 1);
}

template <int dim>
bool CellKinds<dim>::has_crystals(std::size_t kind) const {
  return std::ranges::any_of(phases_[kind], [this](PhaseIndex phase) { return crystals_.contains(phase); });
}

template <int dim>
StiffnessTensor<dim> CellKinds<dim>::tensor(PhaseIndex phase, const Moduli& moduli) const {
  const auto crystal = crystals_.find(phase);
  if (crystal == crystals_.end()) return isotropic_stiffness<dim>(moduli);
  return moduli.shear / crystal->second.shear * crystal->second.stiffness;
}

template <int dim>
typename CellShape<dim>::Stiffness CellKinds<dim>::stiffness(std::size_t kind, std::span<const Moduli> moduli) const {
  if (has_crystals(kind)) {
    typename Shape::PointTensors of_points;
    for (std::size_t p = 0; p < of_points.size(); ++p) {
      of_points[p] = tensor(phases_[kind][p], moduli[phases_[kind][p]]);
    }
    return Shape::stiffness(of_points, volumetric_);
  }
  typename Shape::PointModuli of_points{};
  if (mixed_[kind]) {
    of_points.fill(mixed_[kind]->moduli(moduli));
  } else {
    for (std::size_t p = 0; p < of_points.size(); ++p) of_points[p] = moduli[phases_[kind][p]];
  }
  return Shape::stiffness(of_points, volumetric_);
}

template <int dim>
std::vector<typename CellShape<dim>::Stiffness> CellKinds<dim>::stiffnesses(std::span<const Moduli> moduli) const {
  std::vector<Stiffness> by_kind;
  by_kind.reserve(count());
  for (std::size_t kind = 0; kind < count(); ++kind) {
    by_kind.push_back(has_gaps_[kind] ? Stiffness::Zero() : stiffness(kind, moduli));
  }
  return by_kind;
}

template <int dim>
std::optional<Moduli> CellKinds<dim>::uniform_moduli(std::size_t kind, std::span<const Moduli> moduli) const {
  if (mixed_[kind]) return mixed_[kind]->moduli(moduli);
  const auto& phases = phases_[kind];
  if (is_empty(kind, moduli)) return moduli[phases.front()];
  if (has_crystals(kind)) return std::nullopt;
  const bool is_uniform = std::ranges::count(phases, phases.front()) == Shape::points;
  if (!is_uniform || volumetric_ == Volumetric::standard) return std::nullopt;
  return moduli[phases.front()];
}

template <int dim>
bool CellKinds<dim>::is_empty(std::size_t kind, std::span<const Moduli> moduli) const {
  return !mixed_[kind] && std::ranges::all_of(phases_[kind], [&](PhaseIndex phase) { return is_void(moduli[phase]); });
}

template class CellKinds<2>;
template class CellKinds<3>;

}  // namespace breccia::quasistatic
