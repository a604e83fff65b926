#include "homogenisation/separation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "breccia/microstructure/tessellation.hpp"

#include "io/display.hpp"
#include "study/chain.hpp"
#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

/// Ratio of the sizes above which the homogenised stage is a good model of its particles and binder.
constexpr double enough = 5.0;

/// The nearest earlier stage in the chain of matrices that has particles; nullptr if there is none.
const Stage* filled_matrix_of(const Study& study, const Stage& stage) {
  const auto* below = stage_of_matrix(study, stage);
  while (below != nullptr && below->fillers.empty()) below = stage_of_matrix(study, *below);
  return below;
}

/// The diameters of the particles of a stage; for cells around listed sites the diameters of discs of the same area, or
/// of balls of the same volume.
struct ParticleSizes {
  const Stage& stage;

  template <int dim>
  std::optional<DiameterRange> operator()(const LaguerrePacking<dim>& grains) const {
    if (grains.is_random()) return diameters_of(stage);
    const auto volumes = cell_volumes(Tessellation<dim>({stage.side, grains.walls, grains.sites}));
    const auto [smallest, largest] = std::ranges::minmax(volumes);
    return DiameterRange{diameter_of<dim>(smallest), diameter_of<dim>(largest)};
  }
  template <class Packing>
  std::optional<DiameterRange> operator()(const Packing&) const {
    return diameters_of(stage);
  }

 private:
  template <int dim>
  static double diameter_of(double volume) {
    if constexpr (dim == 3) return std::cbrt(6.0 * volume / std::numbers::pi);
    return 2.0 * std::sqrt(volume / std::numbers::pi);
  }
};

std::optional<DiameterRange> particle_sizes(const Stage& stage) {
  return visit_nested(ParticleSizes{stage}, stage.packing);
}

}  // namespace

std::optional<std::string> warning_of_separation(const Study& study, const Stage& stage,
                                                 const StageMicrostructure& packed) {
  const auto* const matrix = filled_matrix_of(study, stage);
  if (matrix == nullptr || stage.fillers.empty()) return std::nullopt;
  const auto own = particle_sizes(stage), below = particle_sizes(*matrix);
  if (!own || !below) return std::nullopt;
  constexpr auto where = "(docs/limitations.md, Separation of sizes)";
  if (own->largest < below->largest) {
    return fmt::format(
        "its particles, up to {}, are smaller than those of its matrix {}, up to {}: the stages are in "
        "the wrong order: the particles in a matrix must be far smaller {}",
        display(own->largest, "m"), matrix->name, display(below->largest, "m"), where);
  }
  const double factor = own->smallest / below->largest;
  const double gap = std::min(packed.gap, packed.wall_gap);
  constexpr double rounding = 1e-9;
  const bool is_near = factor < enough * (1.0 - rounding), is_narrow = gap < below->largest;
  if (!is_near && !is_narrow) return std::nullopt;
  const auto others = fmt::format("the largest of its matrix {}, {}", matrix->name, display(below->largest, "m"));
  const auto how_wide = factor < 1.05 ? "no wider than" : fmt::format("only {:.2g} times as wide as", factor);
  const auto sizes = fmt::format("its smallest particles, {}, are {} {} (expected {:g} times or more)",
                                 display(own->smallest, "m"), how_wide, others, enough);
  const auto gaps =
      fmt::format("its smallest gap, {}, is narrower than {}", display(gap, "m"), is_near ? "those" : others);
  return fmt::format(
      "{}{}{}; the result may be off by tens of per cent more than its error says, and its bounds need not be bounds "
      "{}",
      is_near ? sizes : "", is_near && is_narrow ? ", and " : "", is_narrow ? gaps : "", where);
}

}  // namespace breccia
