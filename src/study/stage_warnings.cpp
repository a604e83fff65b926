#include "breccia/study/stage_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "breccia/io/units.hpp"
#include "breccia/study/quality.hpp"

namespace breccia {
namespace {

std::optional<std::string> warning_of_narrow_gaps(const Stage& stage, const StageMicrostructure& packed) {
  constexpr double cells_per_gap = 3.0;
  constexpr double rounding = 1e-9;
  const double gap = std::min(packed.gap, packed.wall_gap);
  const double cells = gap / stage.cell_size();
  if (cells >= cells_per_gap * (1.0 - rounding)) return std::nullopt;
  const double needed = std::ceil(cells_per_gap * stage.side / gap);
  constexpr double affordable = 20000.0;
  return fmt::format(
      "the smallest gap between particles or to a wall, {}, is {:.2g} cells wide; below {:g} the "
      "modulus at long times comes out several times too high, and tens of times at 1{}",
      readable(gap, Dimension::length), cells, cells_per_gap,
      needed <= affordable ? fmt::format(" (cells = {:.0f} would resolve it)", needed) : "");
}

std::optional<std::string> warning_of_cut_particles(const std::vector<Bound>& bounds,
                                                    const StageMicrostructure& packed) {
  const bool cuts = std::ranges::any_of(bounds, [](Bound bound) { return bound != Bound::periodic; });
  if (packed.microstructure.walls != Walls::periodic || !cuts) return std::nullopt;
  return "the boundaries of the upper and lower bound cut the particles that cross the sides of this periodic box; "
         "under the upper one they bridge it, and the modulus at long times comes out far too high; "
         "packing.walls = true keeps them inside";
}

/// A single term is a model of its own; several are data, which end somewhere.
std::optional<std::string> warning_of_unknown_times(const Stage& stage, const Tests& tests) {
  const auto* matrix = std::get_if<Material>(&stage.matrix);
  if (matrix == nullptr || matrix->shear.terms().size() < 2) return std::nullopt;
  // A term is felt for a decade on either side.
  constexpr double decade = 10.0;
  const double slowest = matrix->shear.terms().front().relaxation_time;
  const double fastest = matrix->shear.terms().back().relaxation_time;
  if (tests.first_time >= fastest / decade && tests.last_time <= slowest * decade) return std::nullopt;
  return fmt::format(
      "times reach from {} to {}, but the relaxation times of the shear modulus of its matrix, {}, from {} to {} only; "
      "beyond them it is constant, whatever the material does",
      readable(tests.first_time, Dimension::time), readable(tests.last_time, Dimension::time), matrix->name,
      readable(fastest, Dimension::time), readable(slowest, Dimension::time));
}

}  // namespace

std::vector<std::string> warnings_on(const Study& study, const Stage& stage,
                                     const StageMicrostructure& microstructure) {
  std::vector<std::string> warnings;
  for (const auto& warning :
       {warning_of_narrow_gaps(stage, microstructure), warning_of_cut_particles(study.tests.bounds, microstructure),
        warning_of_unknown_times(stage, study.tests)}) {
    if (warning) warnings.push_back(fmt::format("{}: {}", stage.name, *warning));
  }
  for (const auto& warning : warnings_on_packing(stage, microstructure)) {
    warnings.push_back(fmt::format("{}: {}", stage.name, warning));
  }
  return warnings;
}

}  // namespace breccia
