#include "homogenisation/crystal_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "breccia/discretisation/crystals.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"

#include "homogenisation/narrow_gaps.hpp"
#include "study/chain.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

/// The share of the volume of the crystals that lies in mixed cells [-].
double mixed_share(const Study& study, const Stage& stage, const StageMicrostructure& packed) {
  const auto phases = phases_of(stage);
  std::set<PhaseIndex> of_crystals;
  for (const auto& filler : stage.fillers) {
    if (filler.crystal) of_crystals.insert(phases.index_of(phase_of(stage, filler.material)));
  }
  double all = 0.0, unmixed = 0.0;
  const auto count = [&](const auto& cells) {
    const auto by_phase = cells.points_by_phase(phases.size());
    for (const auto phase : of_crystals) all += by_phase[phase];
    for (const auto& cell : cells.cells()) {
      unmixed +=
          static_cast<double>(std::ranges::count_if(cell, [&](auto phase) { return of_crystals.contains(phase); }));
    }
  };
  std::visit(count, discretise(stage, packed, stage.cells, mixing_of(study, stage, packed)));
  return 1.0 - unmixed / all;
}

/// A warning where most of the crystals lie in mixed cells, whose share falls as one over the number of cells.
std::optional<std::string> warning_of_mixed_crystals(const Study& study, const Stage& stage,
                                                     const StageMicrostructure& packed) {
  constexpr double enough = 0.5;
  if (!stage.has_crystals() || model_of(study.tests, stage) == Model::films) return std::nullopt;
  const double mixed = mixed_share(study, stage, packed);
  if (!(mixed > enough)) return std::nullopt;
  return fmt::format(
      "{:.0f} % of the crystals' volume lies in cells that their surfaces cross, which take their isotropic "
      "means, so that the anisotropy comes out too small (cells = {:.0f} would make it half)",
      100.0 * mixed, std::ceil(stage.cells * mixed / enough));
}

}  // namespace

std::vector<std::string> warnings_of_crystals(const Study& study, const Stage& stage,
                                              const StageMicrostructure& packed) {
  constexpr double doubtful = 4.0;
  std::vector<std::string> warnings;
  for (const auto& filler : stage.fillers) {
    if (!filler.crystal) continue;
    const auto& name = filler.material.name;
    const auto means = isotropic_means(stiffness_tensor(filler.crystal->constants));
    const double apart = std::max(means.bulk_voigt / means.bulk_reuss, means.shear_voigt / means.shear_reuss);
    if (apart > doubtful) {
      warnings.push_back(
          fmt::format("{}: Voigt's mean of its constants is {:.2g} times Reuss's; are the units right?", name, apart));
    }
    if (!std::holds_alternative<RandomOrientations>(filler.crystal->orientations) &&
        serves_as_matrix(study.stages, stage.name)) {
      warnings.push_back(
          fmt::format("{}: its orientations may make the stage anisotropic; later stages take it as "
                      "isotropic, with the mean of its shears",
                      name));
    }
  }
  if (stage.has_crystals() && stage.dimensions() == 2) {
    warnings.emplace_back(
        "crystals in a plane: all motion along z is held, which stiffens those without a mirror plane "
        "there; for the modulus take three dimensions");
  }
  if (auto warning = warning_of_mixed_crystals(study, stage, packed)) warnings.push_back(*std::move(warning));
  return warnings;
}

}  // namespace breccia
